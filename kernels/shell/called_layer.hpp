#pragma once
// Layers of any kind behind one type: one compiled shell serves the kinds that take longer than a call, and one
// compiled membrane serves all.
//
// Only the layers of an element know their kind. Its geometry, rates, hourglass modes and forces are long and compiled
// once for all that are called.

#include "kernels/material/type_list.hpp"
#include "kernels/shell/membrane.hpp"

namespace percuss {

/// Points to parameters of any kind of layers.
class AnyShell {
 public:
  AnyShell() = default;
  template <class Layer>
  KOKKOS_INLINE_FUNCTION explicit AnyShell(const ShellParameters<Layer>* of) : kind_(find<Layer>(Kinds())), of_(of) {}

  /// Calls f(parameters) with a pointer of their type.
  template <class F>
  KOKKOS_INLINE_FUNCTION void visit(const F& f) const {
    visit(f, Kinds());
  }

 private:
  using Kinds = TypeList<ElasticLayer, J2Layer, HardeningLayer, LaminateLayer, FabricLayer>;

  template <class Layer, class... Kind>
  KOKKOS_INLINE_FUNCTION static constexpr int find(TypeList<Kind...>) {
    int place = 0;
    static_cast<void>(((std::is_same_v<Layer, Kind> || (++place, false)) || ...));
    return place;
  }
  template <class F, class... Kind>
  KOKKOS_INLINE_FUNCTION void visit(const F& f, TypeList<Kind...>) const {
    int place = 0;
    static_cast<void>(((kind_ == place++ ? (f(static_cast<const ShellParameters<Kind>*>(of_)), true) : false) || ...));
  }

  int kind_ = -1;
  const void* of_ = nullptr;
};

/// A layer that is called.
struct CalledLayer {
  static constexpr int most_history = HardeningLayer::most_history;
  static_assert(most_history >= LaminateLayer::most_history && most_history >= FabricLayer::most_history);
  static constexpr bool can_yield = true;
  PlaneElasticity elasticity, bound;
  AnyShell shell;
  const LaminateLayer* laminate = nullptr;  // null: it is none

  PERCUSS_FORCE_INLINE const LaminateLayer* find_laminate() const { return laminate; }
};

template <>
struct ShellParameters<CalledLayer> {
  CalledLayer material;
  struct {
    int count;
  } points{};
  double offset = 0, stabilization = 1;
  bool is_membrane = false;
};

template <class Layer>
KOKKOS_INLINE_FUNCTION ShellParameters<CalledLayer> call_layers(const ShellParameters<Layer>& of) {
  return {{of.material.elasticity, find_bound(of.material), AnyShell(&of), find_laminate(of.material)},
          {of.points.count},
          of.offset,
          of.stabilization,
          of.is_membrane};
}
PERCUSS_FORCE_INLINE const ShellParameters<CalledLayer>& call_layers(const ShellParameters<CalledLayer>& of) {
  return of;
}

/// Stored forces of layers that never yield keep all that they have.
template <class Layer, class T>
PERCUSS_FORCE_INLINE void complete_flow(FlowShares<T>& flow) {
  if constexpr (!Layer::can_yield) flow.membrane = flow.bending = T(1);
}

/// The function that advance_layers() of each kind is compiled as.
template <class T, class Layer, class Lives>
PERCUSS_NO_INLINE void advance_layers_of(const ShellParameters<Layer>& par, const ElementStep<T>& step, T* layer,
                                         const Lives& lives, LayerSums<T>& sums) {
  sums = advance_layers(par, step, layer, lives);
}

template <class T, class Lives>
PERCUSS_FORCE_INLINE LayerSums<T> advance_layers(const ShellParameters<CalledLayer>& par, const ElementStep<T>& step,
                                                 T* layer, const Lives& lives) {
  LayerSums<T> sums;
  par.material.shell.visit([&]<class Layer>(const ShellParameters<Layer>* of) {
    if constexpr (!is_fabric<Layer>) advance_layers_of(*of, step, layer, lives, sums);
    complete_flow<Layer>(sums.flow);
  });
  return sums;
}

/// Calls the layer of a membrane of fabric.
template <class T, class Lives>
PERCUSS_FORCE_INLINE LayerSums<T> advance_fabric(const ShellParameters<CalledLayer>& par, const ElementStep<T>& step,
                                                 const ShellGeometry<T>& end, T* layer, const Lives& lives,
                                                 T& stiffening) {
  LayerSums<T> sums;
  par.material.shell.visit([&]<class Layer>(const ShellParameters<Layer>* of) {
    if constexpr (is_fabric<Layer>)
      sums = advance_fabric(*of, step, end, layer, lives, stiffening);
    else
      advance_layers_of(*of, step, layer, lives, sums);
    complete_flow<Layer>(sums.flow);
  });
  return sums;
}

}  // namespace percuss
