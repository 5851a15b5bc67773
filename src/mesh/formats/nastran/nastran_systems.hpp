#pragma once
// Coordinate systems of Nastran, in which grid points may be given: rectangular, cylindrical and spherical ones of
// three points (CORD2R, CORD2C, CORD2S), also in each other.

#include <array>
#include <cstdint>
#include <map>
#include <optional>

#include "src/mesh/files/text_source.hpp"
#include "src/mesh/formats/nastran/nastran_cards.hpp"
#include "src/mesh/mesh.hpp"

namespace percuss {

class NastranSystems {
 public:
  explicit NastranSystems(const TextNames& names) : names_(names) {}

  /// An entry whose name begins with CORD. Throws InputError.
  void add(const NastranCards& card);

  /// A point of a system in the basic one, which is number 0; place: where it is given. Throws InputError.
  Vec3 find_place(std::int64_t system, const Vec3& x, TextPlace place) { return find_place(system, x, place, 0); }

 private:
  enum class Kind : std::uint8_t { rectangular, cylindrical, spherical, other };
  struct Frame {
    Vec3 origin{};
    std::array<Vec3, 3> axes{};
  };
  struct System {
    Kind kind = Kind::other;
    std::string name;  // of its entry
    std::int64_t reference = 0;
    std::array<Vec3, 3> points{};  // origin, on the z axis, in the x-z plane
    TextPlace place;
    std::optional<Frame> frame;  // once it is requested
  };

  Vec3 find_place(std::int64_t system, const Vec3& x, TextPlace place, int depth);
  Frame make_frame(const System& system, std::int64_t id, int depth);
  void define(std::int64_t id, System system);

  const TextNames& names_;
  std::map<std::int64_t, System> systems_;
};

}  // namespace percuss
