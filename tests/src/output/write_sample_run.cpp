// Writes the sample run for readers that are not C++: write_sample_run FOLDER, on any number of ranks.

#include <cstdio>
#include <exception>

#include "src/output/exodus/exodus_results.hpp"
#include "tests/src/output/sample_run.hpp"

int main(int count, char** arguments) {
  using namespace percuss;
  const MpiSession mpi(count, arguments);
  if (count != 2) return 2;
  try {
    std::filesystem::create_directories(arguments[1]);
    const Communicator ranks = Communicator::world();
    const ChunkedMesh share = sample::take_share(sample::cut_layers(sample::make_mesh()), ranks);
    FieldsFile file(arguments[1], share, sample::options(), ranks);
    for (int frame = 0; frame < 3; ++frame) sample::write_frame(file, share.mesh, frame);
    file.close();
    ExodusResults exodus(arguments[1], share, sample::options(), ranks);
    for (int frame = 0; frame < 3; ++frame) sample::write_frame(exodus, share.mesh, frame);
    exodus.close();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 4;
  }
  return 0;
}
