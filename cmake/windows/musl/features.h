/* What musl's sources take of its own header of this name. */
#define hidden
