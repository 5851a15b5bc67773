#include "src/step/model/element_bounds.hpp"

#include "kernels/core/small_space.hpp"

namespace percuss {

ElementBounds::ElementBounds(const Model& model) : chunks(model.chunks) {
  watch.bound = Array<Real>("percuss::element_bounds", model.chunks.corner_slots.extent(0) / 8);
  watch.growth = Array<double>("percuss::growth", static_cast<std::size_t>(model.chunks.count));
  if (model.has_rotations || model.has_beams)
    others = Array<double>("percuss::shell_and_beam_bounds", static_cast<std::size_t>(model.element_count));
}

std::vector<double> ElementBounds::list() const {
  const auto count = to_host(chunks.first_element)(static_cast<std::size_t>(chunks.count));
  const Array<double> all("percuss::bounds_of_elements", static_cast<std::size_t>(count));
  const ElementBounds bounds = *this;
  parallel_for(
      "percuss::list_bounds", RangeOf(ExecSpace(), 0, chunks.count), KOKKOS_LAMBDA(const int c) {
        for (int i = 0; i < count_elements(bounds.chunks, c); ++i)
          all(find_element(bounds.chunks, c, i)) = bounds(c, i);
      });
  const auto host = to_host(all);
  return {host.data(), host.data() + host.extent(0)};
}

}  // namespace percuss
