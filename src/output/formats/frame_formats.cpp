#include "src/output/formats/frame_formats.hpp"

#include "src/output/exodus/exodus_results.hpp"
#include "src/output/files/first_rank.hpp"
#include "src/output/vtkhdf/fields_file.hpp"

namespace percuss {
namespace {

template <class Writer>
std::unique_ptr<FrameWriter> create(const FrameTarget& to) {
  return std::make_unique<Writer>(to.directory, to.chunked, to.options, to.ranks);
}

template <class Writer>
std::unique_ptr<FrameWriter> resume(const FrameTarget& to, std::int64_t frames, std::span<const std::string> fields) {
  return std::make_unique<Writer>(to.directory, to.chunked, to.options, to.ranks, frames, fields);
}

template <class Writer>
FrameFormat make_format(FieldsFormat format, const FrameLayout& layout, std::vector<const char*> index_ends,
                        bool wants_sets) {
  return {format, layout, std::move(index_ends), wants_sets, create<Writer>, resume<Writer>};
}

}  // namespace

const std::vector<FrameFormat>& frame_formats() {
  static const std::vector<FrameFormat> formats{
      make_format<FieldsFile>(FieldsFormat::vtkhdf, vtkhdf_frames, {".xdmf", ".xdmf2"}, false),
      make_format<ExodusResults>(FieldsFormat::exodus, exodus_frames, {}, true),
  };
  return formats;
}

std::vector<std::string> FrameFormat::list_endings() const {
  std::vector<std::string> endings{layout.ending};
  endings.insert(endings.end(), index_ends.begin(), index_ends.end());
  return endings;
}

std::vector<const FrameFormat*> list_formats(const FieldsDeck& fields) {
  std::vector<const FrameFormat*> chosen;
  for (const FrameFormat& format : frame_formats()) {
    if (fields.has_format(format.format)) chosen.push_back(&format);
  }
  return chosen;
}

void check_earlier_frames(const FrameFormat& format, const EarlierFrames& earlier, const ChunkedMesh& chunked,
                          const Communicator& ranks) {
  const std::string path = earlier.directory + "/" + format.layout.name_file(earlier.name);
  const FramesInFile kept = find_kept(chunked, earlier.frames);
  run_on_first_rank(ranks, [&] { check_earlier_results(format.layout, path, kept, earlier.fields); });
}

}  // namespace percuss
