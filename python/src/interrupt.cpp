// SPDX-License-Identifier: MIT
#include "interrupt.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <mutex>
#include <system_error>
#include <thread>

#include "bindings.hpp"

namespace tutavia_python {

namespace {

// What the handler of the signal reads.
std::atomic<int> wake_end{-1};  // of the pipe on which the thread of the module waits
std::atomic<std::uint64_t> current_watch{0};
std::atomic<std::uint64_t> interrupted_watch{0};
struct sigaction python_action {};
static_assert(std::atomic<std::uint64_t>::is_always_lock_free);

// With the GIL alone.
bool is_python_action_known = false;
bool is_watching = false;
unsigned long main_thread = 0;
PyObject *get_handler = nullptr, *default_handler = nullptr, *sigint = nullptr;

void on_sigint(int number, siginfo_t*, void*) {
  const int error = errno;
  interrupted_watch = current_watch.load();
  const char byte = 0;
  [[maybe_unused]] const ssize_t written = write(wake_end, &byte, 1);
  errno = error;
  python_action.sa_handler(number);
}

/// Waits for the handler of the signal, and requests the stop of the watch that was interrupted.
/// Never destroyed: its thread waits until the process ends.
class Waiter {
 public:
  Waiter() {
    int ends[2];
    if (pipe(ends) != 0) throw std::system_error(errno, std::generic_category(), "pipe");
    for (const int end : ends) fcntl(end, F_SETFD, FD_CLOEXEC);
    fcntl(ends[1], F_SETFL, O_NONBLOCK);
    wake_end = ends[1];
    std::thread([this, end = ends[0]] { wait(end); }).detach();
  }

  std::stop_token begin() {
    const std::lock_guard lock(mutex_);
    if (source_.stop_requested()) source_ = {};
    ++current_watch;
    return source_.get_token();
  }
  void end() {
    const std::lock_guard lock(mutex_);
    ++current_watch;
  }

 private:
  void wait(int end) {
    // Handlers of signals belong to other threads.
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_BLOCK, &all, nullptr);
    for (char byte = 0;;) {
      const ssize_t count = read(end, &byte, 1);
      if (count < 0 && errno == EINTR) continue;
      if (count <= 0) return;
      const std::lock_guard lock(mutex_);
      if (interrupted_watch == current_watch) source_.request_stop();
    }
  }

  std::mutex mutex_;
  std::stop_source source_;
};

Waiter* waiter = nullptr;

/// Whether the module's handler stands before Python's. Not before the handler of another library
/// that came later: that one may call this one.
bool stands_before_python() {
  struct sigaction now {};
  sigaction(SIGINT, nullptr, &now);
  if ((now.sa_flags & SA_SIGINFO) != 0 && now.sa_sigaction == &on_sigint) return true;
  const bool is_function =
      (now.sa_flags & SA_SIGINFO) == 0 && now.sa_handler != SIG_DFL && now.sa_handler != SIG_IGN;
  if (!is_function) return false;  // another library has put it there
  if (is_python_action_known && now.sa_handler != python_action.sa_handler) return false;
  python_action = now;
  is_python_action_known = true;
  now.sa_sigaction = &on_sigint;
  now.sa_flags |= SA_SIGINFO;
  return sigaction(SIGINT, &now, nullptr) == 0;
}

}  // namespace

SigintWatch::SigintWatch() {
  if (waiter == nullptr) waiter = new Waiter;
  token_ = waiter->begin();
  is_watching = true;
}

SigintWatch::~SigintWatch() {
  is_watching = false;
  if (waiter != nullptr) waiter->end();  // it is not there in a child forked by a handler
}

Hearing hearing() {
  if (PyThread_get_thread_ident() != main_thread) return Hearing::none;
  const auto handler =
      py::reinterpret_steal<py::object>(PyObject_CallFunctionObjArgs(get_handler, sigint, nullptr));
  if (!handler) throw py::error_already_set();
  if (PyCallable_Check(handler.ptr()) == 0) return Hearing::none;
  // A handler that runs during a watch may plan, too.
  const bool may_watch = handler.ptr() == default_handler && !is_watching && stands_before_python();
  return may_watch ? Hearing::watched : Hearing::asked;
}

void bind_interrupt(py::module_& m) {
  const auto start = [] {
    // The thread of the module is gone, and the pipe is that of the parent.
    main_thread = PyThread_get_thread_ident();
    wake_end = -1;  // the child may close it and open a file of the same number
    is_watching = false;
    waiter = nullptr;
  };
  main_thread =
      py::module_::import("threading").attr("main_thread")().attr("ident").cast<unsigned long>();
  // The functions of the module in C: those of `signal` wrap their results, which takes longer.
  const auto signal = py::module_::import("_signal");
  get_handler = py::object(signal.attr("getsignal")).release().ptr();
  default_handler = py::object(signal.attr("default_int_handler")).release().ptr();
  sigint = PyLong_FromLong(SIGINT);
  m.def("_after_fork", start, "Prepares a forked process.");
  using namespace pybind11::literals;
  py::module_::import("os").attr("register_at_fork")("after_in_child"_a = m.attr("_after_fork"));
}

}  // namespace tutavia_python
