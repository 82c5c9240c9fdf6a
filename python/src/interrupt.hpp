// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

#include <optional>
#include <stop_token>

/// \file
/// run_interruptible: long work without the GIL, which Ctrl-C cancels.

namespace tutavia_python {

namespace py = pybind11;

/// Lets other Python threads run.
class GilRelease {
 public:
  GilRelease() : state_(PyEval_SaveThread()) {}
  ~GilRelease() { PyEval_RestoreThread(state_); }
  GilRelease(const GilRelease&) = delete;
  GilRelease& operator=(const GilRelease&) = delete;

 private:
  PyThreadState* state_;
};

/// While one lives in the main thread, SIGINT requests its stop.
///
/// Python's handler of a signal writes the signal's number to a file descriptor
/// (signal.set_wakeup_fd). A SignalWatch lends it a pipe, on which one thread of the process waits;
/// so work that is not interrupted pays for no polling and no thread of its own. Where somebody
/// else's descriptor was there before (that of asyncio, for instance), bytes reach it, too, and it
/// gets its place back afterwards. Else the pipe stays, and is put there again once a millisecond
/// at most: that takes system calls, as long as a short plan. In other threads a watch does
/// nothing, as Python runs handlers in the main thread alone.
class SignalWatch {
 public:
  /// Runs handlers of signals that came before. Throws what they raise.
  SignalWatch();
  ~SignalWatch();
  SignalWatch(const SignalWatch&) = delete;
  SignalWatch& operator=(const SignalWatch&) = delete;

  std::stop_token token() const { return token_; }
  bool was_interrupted() const { return token_.stop_requested(); }

 private:
  void end();

  bool is_watching_ = false;
  int previous_ = -1;  // somebody else's file descriptor, or -1
  std::stop_token token_{};
};

/// Returns `work(token)`, called without the GIL. If SIGINT comes in the main thread, the token is
/// stopped, and what the handler of Python raises is thrown: KeyboardInterrupt. If the handler
/// raises nothing, the work is done anew.
template <class Work>
auto run_interruptible(const Work& work) {
  for (;;) {
    SignalWatch watch;
    auto result = [&] {
      const GilRelease released;
      return work(watch.token());
    }();
    if (!watch.was_interrupted()) return result;
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  }
}

}  // namespace tutavia_python
