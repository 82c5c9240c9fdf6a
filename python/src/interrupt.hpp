// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

#include <chrono>
#include <future>
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

/// While one lives, SIGINT requests its stop, and then reaches Python's handler as before. The
/// handler of the signal only wakes a thread of the module, which waits for that; so work that is
/// not interrupted pays for no polling and no thread of its own.
class SigintWatch {
 public:
  /// \pre `hearing()` has just answered `watched`
  SigintWatch();
  ~SigintWatch();
  SigintWatch(const SigintWatch&) = delete;
  SigintWatch& operator=(const SigintWatch&) = delete;

  const std::stop_token& token() const { return token_; }
  bool was_interrupted() const { return token_.stop_requested(); }

 private:
  std::stop_token token_{};
};

/// How SIGINT is heard during work. All of this is for the main thread, with the GIL.
enum class Hearing {
  none,     ///< not at all: other threads, and processes whose SIGINT is no matter of Python's
  watched,  ///< by a SigintWatch: Python's own handler, which always raises KeyboardInterrupt
  asked,    ///< by asking every few milliseconds: handlers of users, which may raise or not
};
/// The way for the handler that is there now. Puts the module's handler before Python's own one,
/// and leaves it there: a system call to see that it still is takes as long as half a short plan.
Hearing hearing();

/// Throws what handlers of signals raise that came meanwhile.
inline void run_signal_handlers() {
  if (PyErr_CheckSignals() != 0) throw py::error_already_set();
}

/// Returns `work(token)` from another thread. Python's handlers run meanwhile; when one raises,
/// the token is stopped, and what it raised is thrown.
template <class Work>
auto run_asking(const Work& work) {
  std::stop_source stop;
  auto future = std::async(std::launch::async, [&] { return work(stop.get_token()); });
  const auto is_ready = [&future] {
    const GilRelease released;
    return future.wait_for(std::chrono::milliseconds(2)) == std::future_status::ready;
  };
  while (!is_ready()) {
    if (PyErr_CheckSignals() == 0) continue;
    py::error_already_set raised;
    stop.request_stop();
    while (!is_ready()) {
    }
    throw raised;
  }
  return future.get();
}

/// Returns `work(token)`, called without the GIL. At SIGINT in the main thread, if its handler
/// raises, the token is stopped, and what it raised is thrown: KeyboardInterrupt. A handler that
/// raises nothing cancels nothing. While Python's own handler of SIGINT is in place, handlers of
/// other signals run when the work has ended, and so does `_thread.interrupt_main`, which is no
/// signal.
template <class Work>
auto run_interruptible(const Work& work) {
  const Hearing how = hearing();
  if (how == Hearing::asked) return run_asking(work);
  if (how == Hearing::none) {
    const GilRelease released;
    return work(std::stop_token());
  }
  const SigintWatch watch;
  run_signal_handlers();
  auto result = [&] {
    const GilRelease released;
    return work(watch.token());
  }();
  if (!watch.was_interrupted()) return result;
  run_signal_handlers();
  PyErr_SetNone(PyExc_KeyboardInterrupt);
  throw py::error_already_set();
}

}  // namespace tutavia_python
