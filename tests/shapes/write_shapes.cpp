// write_shapes FOLDER: every shape of the tests as outline JSON, own ones and those of the data folder, for scripts that plan them.
#include <cstdio>
#include <filesystem>
#include <vector>

#include "base/file.h"
#include "support/shapes.h"

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "write_shapes FOLDER\n");
    return 2;
  }
  const std::filesystem::path folder = argv[1];
  std::filesystem::create_directories(folder);
  std::vector<clearcut::OutputFile> files;
  for (const auto& shape : clearcut::test_support::all_shapes())
    files.push_back({(folder / (shape.name + ".json")).string(), shape.text});
  clearcut::write_files(files);
}
