#include <gsl/gsl_errno.h>
#include <omp.h>
#include <pthread.h>
#include <pybind11/pybind11.h>

#include <exception>
#include <utility>

#include "base/errors.hpp"
#include "python/functions.hpp"
#include "python/messages.hpp"

PYBIND11_MODULE(core, module) {
    gsl_set_error_handler_off();  // which would end the process
    // OpenMP's threads do not survive a fork; the child would wait for them for ever.
    pthread_atfork(nullptr, nullptr, [] { omp_set_num_threads(1); });
    pybind11::register_exception_translator([](std::exception_ptr thrown) {
        try {
            std::rethrow_exception(std::move(thrown));
        } catch (const base::InvalidInput& invalid) {
            PyErr_SetString(PyExc_ValueError, python::in_python(invalid.what()).c_str());
        } catch (const base::FailedComputation& failed) {
            PyErr_SetString(PyExc_RuntimeError, python::in_python(failed.what()).c_str());
        }
    });
    module.def("in_python", &python::in_python);
    python::define_operators(module);
    python::define_weights(module);
    python::define_solve(module);
}
