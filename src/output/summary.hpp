#pragma once
// summary.json: what a run did, in numbers whose keys do not change meaning (docs/output.md).

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "kernels/core/precision.hpp"
#include "kernels/core/work_kinds.hpp"
#include "src/warning.hpp"

namespace percuss {

/// Seconds spent in each phase of the loop.
struct PhaseSeconds {
  double internal_force = 0, halo = 0, integrate = 0, contact_rcb = 0, contact_search = 0, contact_check = 0,
         contact_enforce = 0, reduce = 0, estimate = 0, output = 0;
};

/// Calls take(key, seconds) for each phase.
template <class Phases, class Take>
void visit_phases(Phases& phases, const Take& take) {
  take("internal_force", phases.internal_force);
  take("halo", phases.halo);
  take("integrate", phases.integrate);
  take("contact_rcb", phases.contact_rcb);
  take("contact_search", phases.contact_search);
  take("contact_check", phases.contact_check);
  take("contact_enforce", phases.contact_enforce);
  take("reduce", phases.reduce);
  take("estimate", phases.estimate);
  take("output", phases.output);
}

/// Cost of the runs that a restarted run continues, up to its checkpoint.
struct EarlierSummary {
  std::int64_t runs = 0, steps = 0;
  double setup_s = 0, loop_s = 0;  // sums of those of the runs
  PhaseSeconds phases_s;           // likewise
};

/// Energies [energy unit] at the end of the run; `error` is relative to the largest energy held so far
/// (docs/output.md).
struct EnergySummary {
  double initial = 0, kinetic = 0;
  std::array<double, work_kinds> work{};  // of elements, by WorkKind
  double contact = 0, friction = 0, damping = 0, external = 0, error = 0;
  double contact_taken = 0;  // by normal contact, for good: all but what its springs hold; 0: no more than round-off
  double largest = 0;        // that was held in any state

  double internal() const { return work[WorkKind::internal]; }
  double hourglass() const { return work[WorkKind::hourglass]; }
};

/// Eroded elements: their mass, the share of it that has left the scene with removed nodes, their internal, hourglass
/// and viscous energy, and the energy of such nodes.
struct ErodedSummary {
  std::int64_t elements = 0;
  double mass = 0, energy = 0, vanished_mass = 0;
};

struct MomentumSummary {
  double linear[3] = {0, 0, 0}, angular[3] = {0, 0, 0};
  double linear_error = 0, angular_error = 0;  // relative: see docs/output.md
};

/// Dynamic relaxation before time 0; empty state: there was none.
struct RelaxationSummary {
  std::string state;          // settled, unsettled
  std::int64_t steps = 0;     // that it took
  double kinetic_ratio = 0;   // kinetic energy at its end over `scale`
  double scale = 0;           // the larger of the largest kinetic energy and the energy that elements and springs hold
  double frequency = 0;       // estimate of the lowest [1 / time]
  double energy = 0;          // that elements and springs hold at time 0
  double preload_error = 0;   // largest of a section, relative to its preload
  double contact_stored = 0;  // energy in springs of penalty contact at time 0
};

/// The event of a sensor.
struct SensorSummary {
  std::string sensor;
  double time = 0, value = 0;  // of the event, without the delay; the value that it saw: of a time, that
};

struct Summary {
  std::string status = "failed";  // running, completed, failed, interrupted
  std::string error;              // empty unless failed
  std::vector<Warning> warnings;  // in the order in which they were found; rank 0
  std::string version, backend, precision = precision_name;
  int ranks = 1, threads = 1;
  std::int64_t elements = 0, nodes = 0, contact_nodes = 0, contact_faces = 0, steps = 0;
  double time = 0, end_time = 0;             // end_time: time.end of the deck; 0: not known
  std::string ended_by;                      // the sensor that has ended the run; empty: none
  std::vector<std::string> restart_changes;  // values of the deck that differ from those of the checkpoint
  std::vector<SensorSummary> sensors;        // sensors whose events have occurred, in the order of the deck
  struct {
    double min = 0, max = 0, last = 0;
    std::int64_t element = 0;  // id of the element that controls the last step
    std::string spring;        // that controls it instead; empty: none
    std::string approach;      // of bodies that controls it instead of both; empty: none
    std::string estimate = "element";
    std::int64_t estimates = 0;  // of the largest eigenvalue of the mesh
    double gain = 1;             // mean over the steps of the bound taken over the least bound of an element
  } dt;
  struct {
    double added = 0, share = 0;    // by mass scaling; of the scene's mass before
    double in_run = 0, energy = 0;  // what of it was added after the start; kinetic energy that came with this
  } mass;
  RelaxationSummary relaxation;
  double setup_s = 0, loop_s = 0, grind_ns = 0;
  PhaseSeconds phases_s;
  EarlierSummary earlier;
  struct {
    double chunk_updates = 0, searches = 0, pair_checks = 0, wall_looks = 0, enforcements = 0, rebalances = 0;
  } skipped;
  EnergySummary energy;
  MomentumSummary momentum;
  ErodedSummary eroded;
  struct {
    double elements = 1, contact = 1;
  } balance;
  struct {
    double count = 0, bytes = 0;
  } messages;
  struct {
    std::int64_t rebalances = 0, ghost_faces = 0;
    double worst_imbalance = 1, rounds_per_cut = 0;
  } decomposition;  // for contact
  std::int64_t peak_bytes = 0;
  std::string state_hash;  // 16 hexadecimal digits
  struct {
    std::string file, values;           // values: all of them as JSON, with the settings; empty: not known
    std::vector<std::string> settings;  // the --set arguments
  } deck;
};

/// Writes the summary (write, sync, rename). Throws SystemError.
void write_summary(const std::string& path, const Summary& summary);

/// "stopped by time.max_steps at 2.9 % of time.end", or by a sensor; empty: the run came to its end, or did not
/// complete.
std::string describe_step_limit(const Summary& summary);

/// "3 warnings: see DIR/summary.json", the last line of a run; empty: there were none.
std::string describe_warnings(const Summary& summary, const std::string& directory);

/// The cost of earlier runs as a text that a checkpoint keeps, and back. Throws InputError if it is another text; path:
/// of the file that has it.
std::string write_earlier(const EarlierSummary& earlier);
EarlierSummary read_earlier(const std::string& text, const std::string& path);

/// Reads one back. Throws InputError with the place if it is not a summary, SystemError if it cannot be read.
Summary read_summary(const std::string& path);

}  // namespace percuss
