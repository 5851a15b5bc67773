#include "src/mesh/pieces/check_pieces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <variant>

#include "comm/agreement.hpp"
#include "src/error.hpp"
#include "src/fail_together.hpp"
#include "src/mesh/quality/check_mesh.hpp"

namespace percuss {
namespace {

/// Its equal share of the nodes of a part, so that each is looked at once.
void check_nodes(const ScenePart& part, const Communicator& ranks, GeometryFindings& findings) {
  const ShapeSource& source = *part.generated->source;
  const std::int64_t first = part.nodes * ranks.rank() / ranks.size();
  const std::int64_t last = part.nodes * (ranks.rank() + 1) / ranks.size();
  for (std::int64_t n = first; n < last; ++n) {
    const auto [copy, node] = std::div(static_cast<long>(n), static_cast<long>(source.node_count()));
    findings.check_node(part.first_node_id + n,
                        part.generated->place(source.place(static_cast<int>(node)), static_cast<int>(copy)));
  }
}

/// All elements of a generated part have the same topology.
void check_chunk(const ChunkPieces& pieces, std::size_t chunk, const Topology& topology, GeometryFindings& findings) {
  std::vector<std::int64_t> node_ids;
  for (int e = pieces.first_element[chunk]; e < pieces.first_element[chunk + 1]; ++e) {
    const auto element = static_cast<std::size_t>(e);
    ElementCorners corners;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const auto corner = static_cast<std::size_t>(topology.kernel_corners[i]);
      corners[i] = pieces.places[pieces.find_node(chunk, element, corner)];
    }
    node_ids.clear();
    for (std::size_t c = 0; c < pieces.count_corners(element); ++c)
      node_ids.push_back(pieces.node_ids[pieces.find_node(chunk, element, c)]);
    findings.check_element(topology, pieces.element_ids[element], corners, node_ids);
  }
}

/// Findings by part.
std::vector<GeometryFindings> check_share(const SceneParts& scene, const Communicator& ranks,
                                          const ChunkPieces& pieces) {
  std::vector<GeometryFindings> findings(scene.parts.size());
  for (std::size_t p = 0; p < scene.parts.size(); ++p) {
    if (scene.parts[p].generated) check_nodes(scene.parts[p], ranks, findings[p]);
  }
  for (std::size_t c = 0; c < pieces.chunks.size(); ++c) {
    const auto part = static_cast<std::size_t>(pieces.parts[c]);
    const auto& generated = scene.parts[part].generated;
    if (generated) check_chunk(pieces, c, find_topology(generated->source->topology()), findings[part]);
  }
  return findings;
}

/// Findings as a text of fields, each ended by a character 0, and back.
class FindingsText {
 public:
  static std::string write(const std::vector<GeometryFindings>& findings) {
    std::string text;
    for (std::size_t p = 0; p < findings.size(); ++p) {
      const GeometryFindings& f = findings[p];
      if (f.problems().empty() && f.flat_corners == 0) continue;
      put(text, std::to_string(p));
      write(text, f.nodes);
      write(text, f.elements);
      put(text, std::to_string(f.flat_corners));
      put(text, f.first_flat);
    }
    return text;
  }

  explicit FindingsText(const std::string& text) : text_(text) {}

  /// Appends what the text says to the findings by part.
  void append_to(std::vector<GeometryFindings>& findings) {
    while (next_ < text_.size()) {
      const std::size_t part = get_count();
      GeometryFindings f;
      f.nodes = read_problems();
      f.elements = read_problems();
      f.flat_corners = get_count();
      f.first_flat = get();
      findings[part].append(f);
    }
  }

 private:
  static void put(std::string& text, const std::string& field) { text += field + '\0'; }

  static void write(std::string& text, const Problems& problems) {
    put(text, std::to_string(problems.count()));
    put(text, std::to_string(problems.texts().size()));
    for (const std::string& problem : problems.texts()) put(text, problem);
  }

  std::string get() {
    std::string field = text_.c_str() + next_;
    next_ += field.size() + 1;
    return field;
  }
  std::size_t get_count() { return std::stoul(get()); }

  Problems read_problems() {
    const std::size_t count = get_count();
    std::vector<std::string> texts(get_count());
    for (std::string& text : texts) text = get();
    return Problems::restore(std::move(texts), count);
  }

  const std::string& text_;
  std::size_t next_ = 0;
};

/// Each line of the text after the prefix and before an end of line; the source of the part comes between, unless the
/// line begins with its file already.
std::string prefix_lines(const std::string& text, const std::string& prefix, const PartDeck& part) {
  std::string lines;
  const auto* mesh = std::get_if<FileMesh>(&part.shape);
  for (std::size_t first = 0; first <= text.size();) {
    const std::size_t last = std::min(text.find('\n', first), text.size());
    const std::string line = text.substr(first, last - first);
    const bool names_file = mesh != nullptr && line.starts_with(mesh->file + ":");
    const std::string source = names_file ? fmt::format("part '{}': ", part.name) : describe_source(part);
    lines += fmt::format("{}{}{}\n", prefix, source, line);
    first = last + 1;
  }
  return lines;
}

void report_problems(const Deck& deck, const std::vector<GeometryFindings>& findings, SceneParts& scene) {
  std::string errors;
  for (std::size_t p = 0; p < scene.parts.size(); ++p) {
    ScenePart& part = scene.parts[p];
    if (part.error.empty()) part.error = findings[p].problems().join("");
    findings[p].warn(part.warnings);
    if (part.error.empty()) continue;
    const PartDeck& from = deck.parts[p];
    errors += prefix_lines(part.error, fmt::format("{}: error: ", deck.where(from.place)), from);
  }
  if (!errors.empty()) throw InputError(errors.substr(0, errors.size() - 1));
}

}  // namespace

void check_pieces(const Deck& deck, const Communicator& ranks, const ChunkPieces& pieces, SceneParts& scene) {
  std::string own;
  fail_together(ranks, [&] { own = FindingsText::write(check_share(scene, ranks, pieces)); });
  const std::vector<std::string> texts = gather_texts(ranks, own);
  fail_together(ranks, [&] {
    if (ranks.rank() != 0) return;
    std::vector<GeometryFindings> findings(scene.parts.size());
    for (const std::string& text : texts) FindingsText(text).append_to(findings);
    report_problems(deck, findings, scene);
  });
}

}  // namespace percuss
