// SPDX-License-Identifier: MIT
#include "interrupt.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <mutex>
#include <system_error>
#include <thread>

#include "bindings.hpp"

namespace tutavia_python {

namespace {

/// Waits for signals on a pipe and stops the watch that is active. Never destroyed: its thread
/// waits until the process ends.
class Watcher {
 public:
  Watcher() {
    int ends[2];
    if (pipe(ends) != 0) throw std::system_error(errno, std::generic_category(), "pipe");
    read_ = ends[0];
    write_ = ends[1];
    for (const int end : ends) fcntl(end, F_SETFD, FD_CLOEXEC);
    fcntl(write_, F_SETFL, O_NONBLOCK);
    std::thread([this] { wait(); }).detach();
  }

  int descriptor() const { return write_; }

  std::stop_token begin(int forward) {
    const std::lock_guard lock(mutex_);
    if (source_.stop_requested()) source_ = {};
    is_active_ = true;
    forward_ = forward;
    return source_.get_token();
  }
  void end() {
    const std::lock_guard lock(mutex_);
    is_active_ = false;
  }

 private:
  void wait() {
    // Handlers of signals belong to other threads.
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_BLOCK, &all, nullptr);
    for (unsigned char number = 0;;) {
      const ssize_t count = read(read_, &number, 1);
      if (count < 0 && errno == EINTR) continue;
      if (count <= 0) return;
      const std::lock_guard lock(mutex_);
      if (number == SIGINT && is_active_) source_.request_stop();
      if (forward_ >= 0) forwarded_ = write(forward_, &number, 1);
    }
  }

  int read_ = -1, write_ = -1;
  std::mutex mutex_;
  std::stop_source source_;
  bool is_active_ = false;
  int forward_ = -1;
  ssize_t forwarded_ = 0;
};

// Written with the GIL held: at the first watch, and in the child after a fork.
Watcher* watcher = nullptr;
unsigned long main_thread = 0;
using Clock = std::chrono::steady_clock;
Clock::time_point lent_until{};  // until then the pipe is taken to be where it was put

/// signal.set_wakeup_fd(descriptor, warn_on_full_buffer=False): the one that was there before. Its
/// C function is not exported by every build of Python.
int set_wakeup_descriptor(int descriptor) {
  static PyObject* const function =
      py::object(py::module_::import("signal").attr("set_wakeup_fd")).release().ptr();
  static PyObject* const names = py::make_tuple("warn_on_full_buffer").release().ptr();
  const py::int_ number(descriptor);
  PyObject* const arguments[] = {number.ptr(), Py_False};
  const auto before =
      py::reinterpret_steal<py::object>(PyObject_Vectorcall(function, arguments, 1, names));
  if (!before) throw py::error_already_set();
  return before.cast<int>();
}

/// Gives the descriptor that was there before its place back, unless it was closed meanwhile.
void restore(int previous) {
  try {
    set_wakeup_descriptor(previous);
  } catch (const py::error_already_set&) {
    set_wakeup_descriptor(-1);
  }
}

}  // namespace

SignalWatch::SignalWatch() {
  if (PyThread_get_thread_ident() != main_thread) return;
  if (watcher == nullptr) watcher = new Watcher;
  if (const auto now = Clock::now(); now >= lent_until) {
    const int before = set_wakeup_descriptor(watcher->descriptor());
    if (before == watcher->descriptor() || before == -1) {
      lent_until = now + std::chrono::milliseconds(1);
    } else {
      previous_ = before;
    }
  }
  token_ = watcher->begin(previous_);
  is_watching_ = true;
  if (PyErr_CheckSignals() == 0) return;
  py::error_already_set raised;
  end();
  throw raised;
}

SignalWatch::~SignalWatch() {
  if (is_watching_) end();
}

void SignalWatch::end() {
  watcher->end();
  if (previous_ != -1) restore(previous_);
}

void bind_interrupt(py::module_& m) {
  const auto start = [] {
    // The thread is gone, and the pipe is that of the parent.
    main_thread = PyThread_get_thread_ident();
    if (lent_until != Clock::time_point{}) restore(-1);
    watcher = nullptr;
    lent_until = {};
  };
  main_thread =
      py::module_::import("threading").attr("main_thread")().attr("ident").cast<unsigned long>();
  m.def("_after_fork", start, "Prepares a forked process.");
  using namespace pybind11::literals;
  py::module_::import("os").attr("register_at_fork")("after_in_child"_a = m.attr("_after_fork"));
}

}  // namespace tutavia_python
