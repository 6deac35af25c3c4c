// Part of every program for Windows: it writes and reads bytes as they are (no line end becomes two), and a console shows
// UTF-8 and takes colours. program.rc adds that names of files and arguments are UTF-8.
#include <fcntl.h>
#include <io.h>
#include <stdlib.h>
#include <windows.h>

#include <initializer_list>

namespace {

void take_colours(DWORD stream) {
  const HANDLE console = GetStdHandle(stream);
  DWORD mode = 0;
  if (GetConsoleMode(console, &mode) != 0) SetConsoleMode(console, mode | ENABLE_VIRTUAL_TERMINAL_PROCESSING);
}

struct Start {
  Start() {
    _fmode = _O_BINARY;
    for (const int stream : {0, 1, 2}) _setmode(stream, _O_BINARY);
    SetConsoleOutputCP(CP_UTF8);
    for (const DWORD stream : {STD_OUTPUT_HANDLE, STD_ERROR_HANDLE}) take_colours(stream);
  }
};

const Start start;

}  // namespace
