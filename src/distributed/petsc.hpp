#pragma once

#include <petscsys.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace distributed {

/// \throws base::FailedComputation with PETSc's message for an error code. On several processes, prints it in
///         one line and ends them all: a call may fail on one process while the others wait in it.
void require(PetscErrorCode code);

/// The same for what reads the user's options of PETSc.
/// \throws base::InvalidInput in PETSc's words
void require_options(PetscErrorCode code);

/// The arguments of the program, and those of PETSc: names with one dash, each with at most one value. After
/// an option of the program that needs a value, a word such as -pi is this value.
/// \param flags options of the program, which begin with two dashes, without value
std::pair<std::vector<char*>, std::vector<std::string>> divided(int argc, char** argv,
                                                                const std::vector<std::string>& flags);

/// An object of PETSc, destroyed with its owner.
template <class Object, PetscErrorCode (*destroy)(Object*)>
class Owned {
  public:
    Owned() = default;
    Owned(Owned&& other) noexcept : object_(std::exchange(other.object_, nullptr)) {}
    Owned& operator=(Owned&& other) noexcept {
        std::swap(object_, other.object_);
        return *this;
    }
    ~Owned() {
        if (object_ != nullptr) destroy(&object_);
    }
    operator Object() const { return object_; }
    /// Where a function of PETSc puts a new object.
    Object* made() { return &object_; }

  private:
    Object object_ = nullptr;
};

/// A number as PETSc's integer type.
inline PetscInt petsc_int(std::ptrdiff_t number) {
    return static_cast<PetscInt>(number);
}

/// PETSc and SLEPc, from the beginning of a program to its end.
class Petsc {
  public:
    /// \param options those of the command line that are PETSc's: names with one dash, and their values
    explicit Petsc(std::vector<std::string> options);
    Petsc(const Petsc&) = delete;
    Petsc& operator=(const Petsc&) = delete;
    ~Petsc();

    /// \throws base::InvalidInput with an option that nothing has asked for, such as a misspelt one
    void require_used() const;

  private:
    std::vector<std::string> options_;
};

/// Whether the user gave one of some options of PETSc.
bool has_options(const std::vector<std::string>& names);

/// Gives an option unless the user did.
void set_default(const std::string& name, const std::string& value);

}  // namespace distributed
