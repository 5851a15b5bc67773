// Writes the sample run for readers that are not C++: write_sample_run FOLDER.

#include <cstdio>
#include <exception>

#include "tests/src/output/sample_run.hpp"

int main(int count, char** arguments) {
  using namespace percuss;
  if (count != 2) return 2;
  try {
    std::filesystem::create_directories(arguments[1]);
    const Mesh mesh = sample::make_mesh();
    FieldsFile file(arguments[1], mesh, sample::options());
    for (int frame = 0; frame < 3; ++frame) sample::write_frame(file, mesh, frame);
    file.close();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 4;
  }
  return 0;
}
