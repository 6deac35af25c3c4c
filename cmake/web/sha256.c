/* SHA-256 as the C library of the web build has it for passwords; nothing else of OpenSSL is used here. */
#include <crypt_sha256.c> /* musl's; its functions are static */

void clearcut_sha256(const void* data, unsigned long count, unsigned char* digest) {
  struct sha256 state;
  sha256_init(&state);
  sha256_update(&state, data, count);
  sha256_sum(&state, digest);
}
