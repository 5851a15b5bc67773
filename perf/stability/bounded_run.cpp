#include "perf/stability/bounded_run.hpp"

#include <algorithm>
#include <cmath>
#include <exception>

#include "kernels/core/host_copy.hpp"
#include "src/mesh/decomposition/decompose.hpp"
#include "src/step/audit/audit.hpp"
#include "src/step/step.hpp"

namespace percuss {

namespace {

constexpr double most_growth = 20;  // a mode at the limit of stability holds more kinetic energy at n-1/2 than at n
constexpr long steps_between_audits = 20;

/// Adds noise to the velocities of free directions: the same for the same mesh.
void add_noise(const Model& model, double size, const Rows3<double>& v) {
  const auto velocity = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), v);
  const auto inverse_mass = to_host(model.inverse_mass);
  std::uint64_t random = 1;
  for (std::size_t n = 0; n < velocity.extent(0); ++n) {
    for (std::size_t k = 0; k < 3; ++k) {
      random = random * 6364136223846793005u + 1442695040888963407u;  // Knuth, MMIX
      const double value = static_cast<double>(random >> 11) / 4503599627370496.0 - 1;
      if (inverse_mass(n, k) > 0) velocity(n, k) += size * value;
    }
  }
  Kokkos::deep_copy(v, velocity);
}

/// sum m v(n-1/2)^2 / 2: unlike the kinetic energy of the audit it cannot be negative, and grows with any instability.
double find_kinetic_energy(const Model& model, const State& state) {
  const auto mass = to_host(model.mass);
  const auto v = to_host(state.v);
  double sum = 0;
  for (std::size_t n = 0; n < v.extent(0); ++n) {
    for (std::size_t k = 0; k < 3; ++k) sum += 0.5 * mass(n) * v(n, k) * v(n, k);
  }
  return sum;
}

/// A scene in its loop, watched.
class WatchedRun {
 public:
  explicit WatchedRun(const Deck& deck)
      : deck_(deck),
        chunked_(load_mesh(deck, Communicator::world())),
        model_(build_model(deck, chunked_)),
        contact_(chunked_, deck, Communicator::world()),
        state_(make_initial_state(model_)),
        stepper_(deck, chunked_, model_, contact_),
        audit_(model_) {}

  void run(double noise, BoundedRun& trial) {
    add_noise(model_, noise, state_.v);
    if (contact_.is_active()) contact_.prepare(state_.x, state_.v);
    stepper_.start(state_);
    given_ = audit_(state_).energy.initial;
    while (deck_.time.end - state_.time > 1e-12 * deck_.time.end) {
      stepper_.advance(state_);
      trial.steps = state_.step;
      trial.outcome = judge(trial);
      if (!trial.outcome.empty()) return;
    }
    trial.outcome = "bounded";
    trial.is_bounded = true;
  }

 private:
  std::string judge(BoundedRun& trial) {
    if (state_.bound.failed_element >= 0) return "an element fails";
    if (state_.step % steps_between_audits == 0) {
      const EnergySummary energy = audit_(state_).energy;
      given_ = std::max(given_, energy.initial + std::abs(energy.external));
      trial.energy_error = std::abs(energy.error);
      if (!(std::abs(energy.error) <= deck_.audit.max_energy_error)) return "energy balance";
    }
    if (given_ <= 0) return "";  // nothing has moved yet
    const double growth = find_kinetic_energy(model_, state_) / given_;
    if (state_.step > steps_between_audits) trial.growth = std::max(trial.growth, growth);
    return state_.step > steps_between_audits && !(growth <= most_growth) ? "kinetic energy" : "";
  }

  const Deck& deck_;
  ChunkedMesh chunked_;
  Model model_;
  ContactStage contact_;
  State state_;
  Stepper stepper_;
  Audit audit_;
  double given_ = 0;  // energy at the start and work from outside, the most so far
};

}  // namespace

BoundedRun run_bounded(const Deck& deck, double scale, double noise) {
  Deck scaled = deck;
  scaled.time.step_scale = scale;
  BoundedRun trial{scale, false, "", 0, 0, 0};
  try {
    WatchedRun(scaled).run(noise, trial);
  } catch (const std::exception& error) {  // contact gives up on what flies apart
    trial.outcome = error.what();
  }
  return trial;
}

std::vector<BoundedRun> search_largest_scale(const Deck& deck, double low, double high, double tolerance,
                                             double noise) {
  std::vector<BoundedRun> trials{run_bounded(deck, high, noise)};
  if (trials.back().is_bounded) return trials;
  trials.push_back(run_bounded(deck, low, noise));
  if (!trials.back().is_bounded) return trials;
  while (high - low > tolerance) {
    const double middle = 0.5 * (low + high);
    trials.push_back(run_bounded(deck, middle, noise));
    (trials.back().is_bounded ? low : high) = middle;
  }
  return trials;
}

}  // namespace percuss
