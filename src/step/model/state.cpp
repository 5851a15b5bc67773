#include "src/step/model/state.hpp"

#include <tuple>

#include "comm/all_reduce.hpp"
#include "kernels/core/common_record.hpp"
#include "kernels/core/host_copy.hpp"
#include "kernels/core/same_bits.hpp"
#include "kernels/core/small_space.hpp"
#include "kernels/core/view_copy.hpp"
#include "kernels/element/element_records.hpp"
#include "kernels/element/hex8/hex_record.hpp"
#include "kernels/shell/shell_failure.hpp"
#include "src/step/model/element_blocks.hpp"
#include "src/step/model/streamed_view.hpp"

namespace percuss {

namespace {

/// Each element starts undeformed: R = V = I, no stress, its mass from its own volume and density.
Array<Real> make_element_records(const Model& model) {
  const auto elements = make_streamed<Array<Real>>("percuss::elements", model.state_size);
  const ElementChunks chunks = model.chunks;
  parallel_for(
      "percuss::start_elements", RangeOf(ExecSpace(), 0, chunks.count), KOKKOS_LAMBDA(const int c) {
        if (is_shell(chunks, c) || is_beam(chunks, c)) return;
        for (int i = 0; i < count_lanes(chunks, c); ++i) {
          const LaneRecord<Real> record = find_record(chunks, elements, c, i);
          for (int k = 0; k < 3; ++k) record[SolidRecord::rotation + 4 * k] = record[SolidRecord::stretch + k] = 1;
        }
      });
  return elements;
}

/// Element masses into the records.
void set_element_masses(const Model& model, const Array<Real>& elements) {
  const ElementChunks chunks = model.chunks;
  const Array<double> mass = model.element_mass;
  parallel_for(
      "percuss::set_element_masses", RangeOf(ExecSpace(), 0, chunks.count), KOKKOS_LAMBDA(const int c) {
        for (int i = 0; i < count_lanes(chunks, c); ++i)
          find_record(chunks, elements, c, i)[CommonRecord::mass] = static_cast<Real>(mass(find_element(chunks, c, i)));
      });
}

/// History that does not start at zero, at every point of an element the same.
void set_start_history(const Model& model, const Array<Real>& elements) {
  if (model.start_history.values.extent(0) == 0) return;
  const ElementChunks chunks = model.chunks;
  const StartHistory start = model.start_history;
  parallel_for(
      "percuss::set_start_history", RangeOf(ExecSpace(), 0, chunks.count), KOKKOS_LAMBDA(const int c) {
        const int points = chunks.points(c);
        const bool layered = is_shell(chunks, c);
        const int to_point = layered ? find_layer_size(chunks, c) : 1, to_scalar = layered ? 1 : points;
        for (int i = 0; i < count_lanes(chunks, c); ++i) {
          const LaneRecord<Real> record = find_record(chunks, elements, c, i);
          const int row = find_element(chunks, c, i) - chunks.first_element(c);
          for (int k = 0; k < start.count(c); ++k) {
            const double value = start.values(start.first(c) + static_cast<std::size_t>(row * start.count(c) + k));
            const auto kept = static_cast<Real>(value);
            for (int p = 0; p < points; ++p) {
              const int scalar = chunks.history(c) + to_scalar * k + to_point * p;
              record[scalar] = kept;
              if (is_single_precision && !layered)  // its rest
                record[scalar + points * start.count(c)] = static_cast<Real>(value - static_cast<double>(kept));
            }
          }
        }
      });
}

/// Modes of the corners of an element at the start.
KOKKOS_INLINE_FUNCTION VectorModes<double> find_start_modes(const ElementChunks& chunks, int c, int element,
                                                            const Rows3<double>& x) {
  double corners[3][8];
  for (int i = 0; i < 8; ++i) {
    const int node = chunks.slots_to_nodes(number_corner_slot(chunks, c, element, i));
    for (int k = 0; k < 3; ++k) corners[k][i] = x(node, k);
  }
  for (auto& direction : corners) to_modes(direction);
  VectorModes<double> a;
  for (int m = 1; m <= 7; ++m) a[m] = {corners[0][m], corners[1][m], corners[2][m]};
  return a;
}

/// The volumes of points at the start into the records of chunks whose elements keep them.
void set_point_volumes(const Model& model, const Array<int>& ids, const Array<Real>& elements) {
  constexpr int place = HexRecord::point_volumes<HexKind::full>;
  const ElementChunks chunks = model.chunks;
  const Rows3<double> x = model.start;
  parallel_for(
      "percuss::set_point_volumes", RangeOf(ExecSpace(), 0, static_cast<int>(ids.extent(0))),
      KOKKOS_LAMBDA(const int i) {
        const int c = ids(i);
        for (int e = 0; e < count_lanes(chunks, c); ++e) {
          double excess[8];
          find_point_volumes(find_start_modes(chunks, c, e, x), excess);
          const LaneRecord<Real> record = find_record(chunks, elements, c, e);
          for (int p = 0; p < 8; ++p) record[place + p] = static_cast<Real>(excess[p]);
        }
      });
}

template <class Material, HexKind Kind>
void set_point_volumes(const Model& model, const HexBlock<Material, Kind>& block, const Array<Real>& elements) {
  if constexpr (keeps_point_volumes<Material, Kind>) set_point_volumes(model, block.chunks, elements);
}

/// Thickness and rotary inertia of shells into the records.
void start_shells(const Model& model, const Array<Real>& elements) {
  if (!model.has_rotations) return;
  const ElementChunks chunks = model.chunks;
  const Array<double> gyration_square = model.gyration_square, thickness = model.start_thickness;
  parallel_for(
      "percuss::start_shells", RangeOf(ExecSpace(), 0, chunks.count), KOKKOS_LAMBDA(const int c) {
        if (!is_shell(chunks, c)) return;
        for (int i = 0; i < count_lanes(chunks, c); ++i) {
          const LaneRecord<Real> record = find_record(chunks, elements, c, i);
          const int e = find_element(chunks, c, i);
          record[ShellRecord::gyration_square] = static_cast<Real>(gyration_square(e));
          record[ShellRecord::thickness] = static_cast<Real>(thickness(e));
        }
      });
}

void start_damping(const Model& model, State& s) {
  if (!model.damps_stiffness) return;
  const auto slots = static_cast<std::size_t>(model.slot_count);
  s.damping_force = Rows3<double>("percuss::stiffness_damping_force", slots);
  if (model.has_rotations) s.damping_moment = Rows3<double>("percuss::stiffness_damping_moment", slots);
}

void start_connections(const Model& model, State& s) {
  s.springs.resize(model.springs.springs.size());
  s.turn_springs.resize(model.turn_springs.size());
  s.glue_damage.assign(model.glue.points.size(), 0);
  for (const GluePoint& point : model.glue.points) s.glue_arms.push_back(point.arm);
  const auto nodes = static_cast<std::size_t>(model.node_count);
  if (model.ties_rotations) s.tie_moment = Rows3<double>("percuss::tie_moment", nodes);
  if (!model.welds.any() && !model.constraints.any() && !model.embedded.any()) return;
  for (const Weld& weld : model.welds.welds) s.welds.push_back({weld.normal});
  s.constraints.resize(model.constraints.constraints.size());
  s.weld_impulse = Rows3<double>("percuss::weld_impulse", nodes);
  s.weld_moment = Rows3<double>("percuss::weld_moment", nodes);
}

/// Starts the history of fibres besides their stress and plastic strain.
KOKKOS_INLINE_FUNCTION void start_fibres(const BeamParameters& parameters, const LaneRecord<Real>& record) {
  const int count = parameters.fibres.count, more = count_more_history(parameters);
  const LaneRecord<Real> rest = record.from(BeamRecord::fibres + 2 * count);
  for (int i = 0; i < count; ++i)
    for (int k = 0; k < more; ++k) rest[more * i + k] = static_cast<Real>(parameters.called.start[1 + k]);
}

/// Rotary inertia and axes of beams into the records.
void start_beams(const Model& model, const Array<Real>& elements) {
  if (!model.has_beams) return;
  const ElementChunks chunks = model.chunks;
  const Array<double> gyration_square = model.gyration_square;  // empty if all are trusses
  const Rows3<double> axes = model.start_beam_axes;
  const auto parameters = model.others->beams.parameters;
  parallel_for(
      "percuss::start_beams", RangeOf(ExecSpace(), 0, chunks.count), KOKKOS_LAMBDA(const int c) {
        if (!is_beam(chunks, c)) return;
        for (int i = 0; i < count_lanes(chunks, c); ++i) {
          const LaneRecord<Real> record = find_record(chunks, elements, c, i);
          const int e = find_element(chunks, c, i);
          if (gyration_square.extent(0) > 0)
            record[BeamRecord::gyration_square] = static_cast<Real>(gyration_square(e));
          for (int k = 0; k < 3; ++k) record[BeamRecord::e2 + k] = static_cast<Real>(axes(e, k));
          start_fibres(parameters(chunks.parameters(c)), record);
        }
      });
}

KOKKOS_INLINE_FUNCTION std::uint64_t find_bits(double value) {
  union {
    double d;
    std::uint64_t u;
  } both;
  both.d = value;
  return both.u;
}

/// Every element whole.
ElementLives make_lives(const FailingChunks& failing) {
  if (failing.pack_count == 0) return {};
  const auto lanes = static_cast<std::size_t>(failing.pack_count) * pack_width;
  ElementLives lives{Array<Real>("percuss::force_share", lanes),
                     Array<Real>("percuss::work_share", lanes),
                     Array<double>("percuss::element_work", work_kinds * lanes),
                     Array<int>("percuss::steps_left", lanes),
                     Array<double>("percuss::plastic_strain", lanes),
                     Array<double>("percuss::damage", lanes),
                     Array<double>("percuss::second_failure_sum", lanes),
                     Array<double>("percuss::layer_lives", failing.layer_scalars)};
  set_values(lives.force_share, Real(1));
  set_values(lives.work_share, Real(1));
  set_values(lives.steps_left, ElementLives::whole);
  return lives;
}

/// Every layer of shells that can fail whole.
void start_layers(const Model& model, const ElementLives& lives) {
  const FailingChunks failing = model.failing;
  if (failing.layer_scalars == 0) return;
  const ElementChunks chunks = model.chunks;
  parallel_for(
      "percuss::start_layers", RangeOf(ExecSpace(), 0, static_cast<int>(failing.list.extent(0))),
      KOKKOS_LAMBDA(const int i) {
        const int c = failing.list(i);
        if (!is_shell(chunks, c)) return;
        for (int e = 0; e < count_lanes(chunks, c); ++e) {
          double* const rows = find_layer_lives(lives, failing, c, chunks.points(c), e);
          for (int p = 0; p < chunks.points(c); ++p) set_layer_left(find_layer_life(rows, p), ElementLives::whole, 1);
        }
      });
}

Array<double> copy_array(const std::string& label, const Array<double>& from) {
  Array<double> to(label, from.extent(0));
  copy_values(to, from);
  return to;
}

Rows3<double> copy_rows(const std::string& label, const Rows3<double>& from) {
  Rows3<double> to(label, from.extent(0));
  copy_values(to, from);
  return to;
}

ChunkResults make_results(const ElementChunks& chunks) {
  const auto count = static_cast<std::size_t>(chunks.count);
  return {Array<double>("percuss::stable_step", count),
          Array<int>("percuss::controlling_element", count),
          Array<int>("percuss::failed_element", count),
          WorkRows("percuss::work", count),
          Array<int>("percuss::is_settled", count),
          Array<std::int64_t>("percuss::skipped", count),
          Array<double>("percuss::resists", chunks.fold_threshold.extent(0))};
}

/// Starts the rotations of nodes of shells and beams.
void start_rotations(const Model& model, State& s) {
  const auto nodes = static_cast<std::size_t>(model.node_count);
  s.w = Rows3<double>("percuss::w", nodes);
  s.w_before = Rows3<double>("percuss::w_before", nodes);
  s.moment = Rows3<double>("percuss::moment", nodes);
  s.slot_moment = Rows3<double>("percuss::slot_moment", static_cast<std::size_t>(model.slot_count));
  copy_values(s.w, model.start_spin);
  s.inertia = model.inertia;
  s.inverse_inertia = model.inverse_inertia;
  s.spin_tensors = model.spin_tensors;
  if (!s.spin_tensors.any()) return;
  s.spin_tensors.excess = TensorRows("percuss::own_spin_tensors", s.spin_tensors.node.extent(0));
  copy_values(s.spin_tensors.excess, model.spin_tensors.excess);
}

/// Chunks that are not computed do not limit the step, and nothing fails in them.
void rest_uncomputed_chunks(const Model& model, const ChunkResults& results) {
  if (model.is_uncomputed_chunk.extent(0) == 0) return;
  const Array<int> is_uncomputed = model.is_uncomputed_chunk;
  const ElementChunks chunks = model.chunks;
  parallel_for(
      "percuss::rest_uncomputed_chunks", RangeOf(ExecSpace(), 0, chunks.count), KOKKOS_LAMBDA(const int c) {
        if (is_uncomputed(c) == 0) return;
        results.stable_step(c) = INFINITY;
        results.controlling_element(c) = chunks.first_element(c);
        results.failed_element(c) = -1;
      });
}

std::vector<RigidState> make_rigid_states(const Model& model) {
  std::vector<RigidState> states;
  for (const RigidBody& body : model.rigid.bodies)
    states.push_back({body.center, {}, body.velocity, body.inertia * body.spin, body.spin});
  return states;
}

}  // namespace

void own_masses(const Model& model, State& state) {
  if (state.mass.data() != model.mass.data()) return;
  state.mass = copy_array("percuss::own_mass", model.mass);
  state.inverse_mass = copy_rows("percuss::own_inverse_mass", model.inverse_mass);
  if (!model.has_rotations) return;
  state.inertia = copy_array("percuss::own_inertia", model.inertia);
  state.inverse_inertia = copy_rows("percuss::own_inverse_inertia", model.inverse_inertia);
}

Gravity find_gravity(const Model& model, double time) {
  Gravity gravity;
  for (std::size_t k = 0; k < 3; ++k) gravity.g[k] = model.gravity[k](time);
  return gravity;
}

Gravity find_constant_gravity(const Model& model) { return model.gravity_varies ? Gravity{} : find_gravity(model, 0); }

namespace {

void start_loads(const Model& model, State& s) {
  s.pressure_faces = model.pressure_faces;
  s.pressure_sums = PressureSums("percuss::pressure_sums", static_cast<std::size_t>(model.pressure_faces.run_count));
  s.nodal_loads = model.nodal_loads;
}

void start_conditions(const Model& model, State& s) {
  s.happened.assign(model.switches.sensors, 0);
  s.held = model.held;
  s.owned_held = model.owned_held;
  s.held_spins = model.held_spins;
  s.owned_held_spins = model.owned_held_spins;
}

}  // namespace

State make_initial_state(const Model& model) {
  State s;
  const auto nodes = static_cast<std::size_t>(model.node_count);
  s.x = make_streamed<Rows3<double>>("percuss::x", nodes);
  s.v = make_streamed<Rows3<double>>("percuss::v", nodes);
  s.v_before = make_streamed<Rows3<double>>("percuss::v_before", nodes);
  s.force = make_streamed<Rows3<double>>("percuss::force", nodes);
  s.impulse = make_streamed<Rows3<double>>("percuss::impulse", nodes);
  copy_values(s.x, model.start);
  copy_values(s.v, model.start_velocity);
  s.elements = make_element_records(model);
  set_element_masses(model, s.elements);
  set_start_history(model, s.elements);
  std::apply([&](const auto&... block) { (set_point_volumes(model, block, s.elements), ...); },
             model.others->hexahedra);
  start_shells(model, s.elements);
  start_beams(model, s.elements);
  s.slot_force = make_streamed<Rows3<double>>("percuss::slot_force", static_cast<std::size_t>(model.slot_count));
  if (model.has_rotations) start_rotations(model, s);
  start_damping(model, s);
  s.results = make_results(model.chunks);
  rest_uncomputed_chunks(model, s.results);
  s.bodies = make_rigid_states(model);
  s.joints.resize(model.rigid.joints.size());
  start_connections(model, s);
  s.gravity = find_gravity(model, s.time);
  s.lives = make_lives(model.failing);
  start_layers(model, s.lives);
  s.element_mass = model.element_mass;
  s.lumped_mass = s.mass = model.mass;
  s.inverse_mass = model.inverse_mass;
  s.total_mass = model.total_mass;
  start_loads(model, s);
  if (model.scales_in_run) {
    s.element_mass = copy_array("percuss::element_mass_now", model.element_mass);
    s.lumped_mass = copy_array("percuss::lumped_mass", model.mass);
    own_masses(model, s);
  }
  start_conditions(model, s);
  return s;
}

namespace {

std::uint64_t hash_nodes(const Model& model, const State& state) {
  const auto x = state.x, v = state.v, w = state.w;
  const bool turns = model.has_rotations;
  const auto owned = model.owned_nodes;
  const auto numbers = model.node_numbers;
  std::uint64_t hash = 0;
  parallel_reduce(
      "percuss::hash_nodes", RangeOf(ExecSpace(), 0, owned.count),
      KOKKOS_LAMBDA(const int c, std::uint64_t& sum) {
        for (int n = owned.first(c); n < owned.end(c); ++n) {
          std::uint64_t h = mix_bits(static_cast<std::uint64_t>(numbers(n)));
          for (int k = 0; k < 3; ++k) h = mix_bits(mix_bits(h ^ find_bits(x(n, k))) ^ find_bits(v(n, k)));
          for (int k = 0; turns && k < 3; ++k) h = mix_bits(h ^ find_bits(w(n, k)));
          sum += h;  // integers: any order gives the same sum
        }
      },
      hash);
  return hash;
}

/// Mixes the life of an element that can fail into a hash; one that is as at the start adds nothing.
KOKKOS_INLINE_FUNCTION std::uint64_t mix_life(const ElementLives& lives, int lane, std::uint64_t h) {
  if (lives.steps_left(lane) != ElementLives::whole)
    h = mix_bits(h ^ static_cast<std::uint64_t>(lives.steps_left(lane) + 1));
  if (lives.damage(lane) > 0) h = mix_bits(h ^ find_bits(lives.damage(lane)));
  if (lives.second(lane) > 0) h = mix_bits(h ^ find_bits(lives.second(lane)));
  return h;
}

/// Hashes which layers of a shell that can fail have failed.
KOKKOS_INLINE_FUNCTION std::uint64_t mix_layers(double* rows, int points, std::uint64_t h) {
  for (int p = 0; p < points; ++p) {
    const auto left = static_cast<int>(find_layer_life(rows, p)[LayerLives::left * pack_size<double>]);
    if (left != ElementLives::whole) h = mix_bits(h ^ static_cast<std::uint64_t>(points * (left + 1) + p));
  }
  return h;
}

std::uint64_t hash_elements(const Model& model, const State& state) {
  const ElementChunks chunks = model.chunks;
  const auto elements = state.elements;
  const FailingChunks failing = model.failing;
  const ElementLives lives = state.lives;
  const auto first_numbers = model.first_elements;
  std::uint64_t hash = 0;
  parallel_reduce(
      "percuss::hash_elements", RangeOf(ExecSpace(), 0, chunks.count),
      KOKKOS_LAMBDA(const int c, std::uint64_t& sum) {
        for (int i = 0; i < count_elements(chunks, c); ++i) {
          const LaneRecord<const Real> record = find_record(chunks, elements, c, i);
          std::uint64_t h = mix_bits(~static_cast<std::uint64_t>(first_numbers(c) + i));
          const int lane = failing.find_pack(c) < 0 ? -1 : failing.find_pack(c) * pack_width + i;
          if (lane >= 0) h = mix_life(lives, lane, h);
          if (lane >= 0 && is_shell(chunks, c))
            h = mix_layers(find_layer_lives(lives, failing, c, chunks.points(c), i), chunks.points(c), h);
          const bool is_dead = lane >= 0 && lives.steps_left(lane) == 0;
          for (int s = 0; s < chunks.record_size(c) && !is_dead; ++s) h = mix_bits(h ^ find_bits(record.get(s)));
          sum += h;
        }
      },
      hash);
  return hash;
}

}  // namespace

State::State() = default;
State::State(const State&) = default;
State::State(State&&) noexcept = default;
State& State::operator=(const State&) = default;
State& State::operator=(State&&) noexcept = default;
State::~State() = default;

std::uint64_t hash_state(const Model& model, const State& state) {
  std::uint64_t sums[2] = {hash_nodes(model, state), hash_elements(model, state)};
  all_reduce(model.ranks, Reduce::sum, sums);
  return mix_bits(sums[0]) + sums[1];
}

}  // namespace percuss
