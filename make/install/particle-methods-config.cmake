include(CMakeFindDependencyMacro)
find_dependency(Eigen3)
add_library(particle-methods::particle-methods INTERFACE IMPORTED)
get_filename_component(particle_methods_prefix "${CMAKE_CURRENT_LIST_DIR}/../../.." ABSOLUTE)
set_target_properties(particle-methods::particle-methods PROPERTIES
    INTERFACE_COMPILE_FEATURES cxx_std_20
    INTERFACE_COMPILE_DEFINITIONS "EIGEN_MAX_ALIGN_BYTES=64;EIGEN_MAX_STATIC_ALIGN_BYTES=16"
    INTERFACE_INCLUDE_DIRECTORIES "${particle_methods_prefix}/include/particle-methods;/usr/include/suitesparse"
    INTERFACE_COMPILE_OPTIONS -fopenmp
    INTERFACE_LINK_OPTIONS -fopenmp
    INTERFACE_LINK_LIBRARIES
    "Eigen3::Eigen;${particle_methods_prefix}/lib/libparticle-methods.a;umfpack;cholmod;lapacke;openblas;gsl;quadmath")
