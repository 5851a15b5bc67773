#pragma once
// The signals that ask a run to stop: SIGINT, SIGTERM, SIGUSR1, SIGHUP and SIGXCPU.

namespace percuss {

/// Holds them back, also while the program starts itself again. To be called first thing in main().
void hold_stop_signals();

/// Delivers those that have come, and all later ones, to request_stop(). A second SIGINT, or a second SIGTERM of a
/// process without a launcher, ends the process at once; launchers and queueing systems send more than one. A SIGHUP
/// that is ignored, as `nohup` does, stays ignored. Under a launcher SIGCONT requests a checkpoint: Open MPI's sends it
/// a second before SIGTERM, and kills a second after that.
void take_stop_signals();

/// Delivers them as the system does by default: for commands that leave nothing behind.
void release_stop_signals();

}  // namespace percuss
