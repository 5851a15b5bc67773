#include "src/step/assembly/build_failing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "kernels/core/host_copy.hpp"
#include "kernels/element/element_records.hpp"
#include "kernels/material/laws/johnson_cook.hpp"
#include "kernels/material/laws/orthotropic.hpp"
#include "kernels/shell/layer_lives.hpp"
#include "src/deck/laws/laminates.hpp"
#include "src/deck/laws/lost_force.hpp"
#include "src/deck/laws/make_law.hpp"
#include "src/deck/laws/material_properties.hpp"
#include "src/error.hpp"
#include "src/index.hpp"
#include "src/mesh/hex_geometry.hpp"
#include "src/step/elements/build_shells.hpp"

namespace percuss {

namespace {

/// Evolution of damage; what depends on the size of elements is by length.
DamageEvolution make_evolution(const DamageEvolutionDeck& deck) {
  DamageEvolution evolution;
  if (deck.plastic_strain) evolution.by_strain = 1 / *deck.plastic_strain;
  if (deck.displacement) evolution.by_strain = 1 / *deck.displacement;
  if (deck.energy) evolution.by_work = find_mean_share(deck) / *deck.energy;
  evolution.exponent = deck.exponent.value_or(0);
  return evolution;
}

FailureLimits make_limits(const MaterialDeck& material, double step_scale) {
  const FailureDeck& deck = *material.failure;
  FailureLimits limits;
  constexpr double none = FailureLimits::none;
  limits.plastic_strain = deck.plastic_strain.value_or(none);
  limits.principal_stress = deck.principal_stress.value_or(none);
  limits.principal_strain = deck.principal_strain.value_or(none);
  limits.thinning = deck.thinning.value_or(none);
  limits.mean_thinning = deck.mean_thinning.value_or(none);
  if (deck.thinning || deck.mean_thinning) {
    const LameConstants c = find_moduli(material);
    limits.compressibility = 1 / (3 * c.lambda + 2 * c.mu);
  }
  limits.tension = deck.pressure.value_or(none);
  limits.yield_time = deck.yield_time.value_or(none);
  limits.fibre_damage = deck.fibre_damage.value_or(none);
  limits.least_volume = deck.volume_below.value_or(0);
  limits.most_volume = deck.volume_above.value_or(none);
  if (const auto& d = deck.johnson_cook) {
    limits.johnson_cook = {d->d1, d->d2, d->d3, d->d4, d->d5, d->reference_rate};
  }
  const auto& numbers = material.law.numbers;  // numbers that the deck gives
  if (const auto melt = numbers.find("melt_temperature"); melt != numbers.end() && melt->second > 0) {
    const auto room = numbers.find("room_temperature");
    limits.room_temperature = room == numbers.end() ? JohnsonCook{}.room_temperature : room->second;
    limits.melt_temperature = melt->second;
  }
  if (deck.evolution) limits.evolution = make_evolution(*deck.evolution);
  if (const auto& coupling = deck.coupling) {
    limits.coupling.start = coupling->damage.value_or(-1);
    limits.coupling.damage_exponent = coupling->damage_exponent;
    limits.coupling.fade_exponent = coupling->exponent;
  }
  if (deck.shear) limits.shear.pressure_factor = deck.shear->pressure_factor;
  limits.least_step = deck.step.value_or(0) / step_scale;
  limits.takes_inverted = deck.inverted;
  limits.fade_steps = deck.fade_steps;
  limits.layers = deck.layers;
  return limits;
}

/// Criteria of plastic strain are for materials that have one.
void check_failure(const Deck& deck, const MaterialDeck& material) {
  const FailureDeck& failure = *material.failure;
  const bool can_yield = has_scalar(material, HistoryScalar::equivalent_plastic_strain);
  const char* const criterion = failure.plastic_strain         ? "plastic_strain"
                                : failure.johnson_cook         ? "johnson_cook"
                                : !failure.triaxiality.empty() ? "triaxiality"
                                : failure.shear                ? "shear"
                                : failure.yield_time           ? "yield_time"
                                                               : nullptr;
  const auto melt = material.law.numbers.find("melt_temperature");
  const bool never_melts = melt == material.law.numbers.end() || melt->second == 0;
  if (failure.johnson_cook && failure.johnson_cook->d5 != 0 && never_melts &&
      has_scalar(material, HistoryScalar::temperature))
    throw InputError(
        fmt::format("{}: error: material '{}' has the failure criterion johnson_cook with d5 (code of a user tells no "
                    "melting temperature): give melt_temperature, or set d5 to 0",
                    deck.where(material.place), material.name));
  if (can_yield || criterion == nullptr) return;
  throw InputError(
      fmt::format("{}: error: material '{}' has the failure criterion {} (its model never yields): choose a model that "
                  "yields, or another criterion",
                  deck.where(material.place), material.name, criterion));
}

/// Whether some ply of it can fail.
bool has_fibres(const MaterialDeck& material) {
  if (!is_laminate(material)) return false;
  const std::vector<LaminatePly> plies = list_plies(material);
  return std::any_of(plies.begin(), plies.end(), [](const LaminatePly& ply) {
    return ply.law.model == Orthotropic::name && find_constants<Orthotropic>(ply.law).has_strength();
  });
}

/// Criteria of shells or of beams, for elements of another kind.
void refuse_other_elements(const Deck& deck, const ElementBlock& block) {
  const MaterialDeck& material = deck.materials[static_cast<std::size_t>(block.material)];
  const FailureDeck& failure = *material.failure;
  const Topology& topology = find_topology(block.topology);
  const char* criterion = nullptr;
  if (!topology.is_surface() && (failure.thinning || failure.mean_thinning))
    criterion = failure.thinning ? "thinning (of shells)" : "mean_thinning (of shells)";
  if (failure.fibre_damage && !(topology.is_surface() && has_fibres(material)))
    criterion = "fibre_damage (of shells whose plies have strengths)";
  if (!topology.is_solid() && (failure.volume_below || failure.volume_above))
    criterion = failure.volume_below ? "volume_below (of solids)" : "volume_above (of solids)";
  if (!topology.is_line() && (failure.resultants || failure.time))
    criterion = failure.resultants ? "resultants (of beams)" : "time (of beams)";
  if (criterion == nullptr) return;
  const PartDeck& part = deck.parts[static_cast<std::size_t>(block.part)];
  throw InputError(
      fmt::format("{}: error: material '{}' of part '{}' has the failure criterion {}, and the part has "
                  "{} elements: give them a material without it",
                  deck.where(part.place), material.name, part.name, criterion, topology.name));
}

bool evolves_by_size(const FailureDeck& deck) { return deck.evolution && !deck.evolution->plastic_strain; }

/// Whether the limits of an element depend on its size.
bool depends_on_size(const FailureDeck& deck) {
  return !deck.size.empty() || evolves_by_size(deck) || (deck.coupling && !deck.coupling->exponent_of_size.empty());
}

/// Appends the limits of each element of a chunk, whose strains and growth of damage depend on its size.
void add_limits_by_size(const FailureDeck& deck, const FailureLimits& material, const ChunkedMesh& chunked,
                        const Chunk& chunk, std::vector<FailureLimits>& limits) {
  const MaterialTable factor = deck.size.empty() ? MaterialTable{} : make_table(deck.size);
  for (int e = 0; e < chunk.element_count; ++e) {
    const auto element = static_cast<std::size_t>(chunk.first_element) + static_cast<std::size_t>(e);
    const double size = find_element_size(chunked.mesh, element, find_element_volume(chunked.mesh, element));
    limits.push_back(deck.size.empty() ? material : material.scale_strains(factor(size).y));
    if (evolves_by_size(deck)) {
      limits.back().evolution.by_strain *= size;
      limits.back().evolution.by_work *= size;
    }
    if (deck.coupling && !deck.coupling->exponent_of_size.empty())
      limits.back().coupling.fade_exponent = make_table(deck.coupling->exponent_of_size)(size).y;
    limits.back().of_element = true;
  }
}

using Rows = std::vector<std::array<double, 2>>;

/// The tables of a material, and where its limits point to them.
struct TableOfLimits {
  const Rows* rows;
  const MaterialTable** place;
};

std::vector<TableOfLimits> list_tables(const FailureDeck& deck, FailureLimits& limits) {
  std::vector<TableOfLimits> all = {{&deck.triaxiality, &limits.triaxiality}, {&deck.rate, &limits.rate_factor}};
  if (deck.shear) all.push_back({&deck.shear->strain, &limits.shear.strain});
  if (deck.coupling) all.push_back({&deck.coupling->strain, &limits.coupling.strain});
  if (deck.evolution) all.push_back({&deck.evolution->table, &limits.evolution.lost});
  all.erase(std::remove_if(all.begin(), all.end(), [](const TableOfLimits& t) { return t.rows->empty(); }), all.end());
  return all;
}

/// Limits point to the tables of their materials.
void build_tables(const Deck& deck, const std::vector<int>& row_of_material, FailingChunks& failing,
                  std::vector<FailureLimits>& limits) {
  std::vector<MaterialTable> tables;
  std::vector<const MaterialTable**> places;
  for (std::size_t m = 0; m < deck.materials.size(); ++m) {
    if (row_of_material[m] < 0) continue;
    for (const TableOfLimits& table : list_tables(*deck.materials[m].failure, limits[at(row_of_material[m])])) {
      tables.push_back(make_table(*table.rows));
      places.push_back(table.place);
    }
  }
  if (tables.empty()) return;
  failing.tables = to_view("percuss::failure_tables", tables);
  for (std::size_t i = 0; i < places.size(); ++i) *places[i] = failing.tables.data() + i;
}

/// Where the layers of the chunks of shells are that can fail.
void build_failing_layers(Model& model) {
  if (!model.has_rotations) return;
  FailingChunks& failing = model.failing;
  const auto list = to_host(failing.list), points = to_host(model.chunks.points);
  const auto family = to_host(model.chunks.family);
  const HostChunks chunks(model.chunks);
  std::vector<std::size_t> first(static_cast<std::size_t>(model.chunks.count), 0);
  for (std::size_t i = 0; i < list.extent(0); ++i) {
    const auto c = static_cast<std::size_t>(list(i));
    if (family(c) != ElementFamily::shells) continue;
    first[c] = failing.layer_scalars;
    failing.layer_scalars += static_cast<std::size_t>(count_lanes(chunks, list(i))) *
                             static_cast<std::size_t>(LayerLives::count_rows(points(c)));
  }
  if (failing.layer_scalars > 0) failing.first_layer = to_view("percuss::first_failing_layer", first);
}

}  // namespace

void build_failing_chunks(const Deck& deck, const ChunkedMesh& chunked, Model& model) {
  std::vector<FailureLimits> limits;
  std::vector<int> row_of_material(deck.materials.size(), -1);
  for (std::size_t m = 0; m < deck.materials.size(); ++m) {
    if (!deck.materials[m].failure) continue;
    check_failure(deck, deck.materials[m]);
    row_of_material[m] = static_cast<int>(limits.size());
    limits.push_back(make_limits(deck.materials[m], deck.time.step_scale));
  }
  if (limits.empty()) return;
  build_tables(deck, row_of_material, model.failing, limits);
  model.can_erode = true;
  const auto first_pack = to_host(model.chunks.first_pack);
  std::vector<int> list, first, row;
  FailingChunks& failing = model.failing;
  for (std::size_t c = 0; c < chunked.chunks.size(); ++c) {
    const int material = find_block(chunked, chunked.chunks[c]).material;
    row.push_back(is_uncomputed_chunk(deck, chunked.chunks[c]) ? -1
                                                               : row_of_material[static_cast<std::size_t>(material)]);
    first.push_back(row.back() < 0 ? -1 : failing.pack_count);
    if (row.back() < 0) continue;
    refuse_other_elements(deck, find_block(chunked, chunked.chunks[c]));
    list.push_back(static_cast<int>(c));
    const FailureDeck& failure = *deck.materials[static_cast<std::size_t>(material)].failure;
    if (depends_on_size(failure)) {
      const FailureLimits of_material = limits[static_cast<std::size_t>(row.back())];
      row.back() = static_cast<int>(limits.size());
      add_limits_by_size(failure, of_material, chunked, chunked.chunks[c], limits);
    }
    failing.pack_count += first_pack(c + 1) - first_pack(c);
  }
  failing.list = to_view("percuss::failing_chunks", list);
  failing.first_pack = to_view("percuss::first_failing_pack", first);
  failing.row = to_view("percuss::row_of_limits", row);
  failing.limits = to_view("percuss::failure_limits", limits);
  build_failing_layers(model);
}

}  // namespace percuss
