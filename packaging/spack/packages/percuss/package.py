"""Recipe of percuss for Spack: `spack repo add packaging/spack`, then `spack dev-build percuss@develop` in a checkout."""

from spack.package import *


class Percuss(CMakePackage):
    """Explicit impact dynamics with solids, shells and parallel contact."""

    license("BSD-3-Clause")

    version("develop")

    variant("native", default=False, description="Compile for the instruction set of this machine")
    variant("precision", default="double", values=("double", "single"), multi=False, description="Precision of the elements")
    variant("tools", default=True, description="Python libraries that plot, report and view need")

    depends_on("cxx", type="build")
    depends_on("c", type="build")
    depends_on("cmake@3.25:", type="build")
    depends_on("ninja", type="build")
    depends_on("pkgconfig", type="build")
    depends_on("python@3.10:", type=("build", "run"))
    depends_on("py-pyyaml", type="run")  # of percuss import

    depends_on("mpi@3.1:")
    depends_on("kokkos@3.4.1:5 +openmp")
    depends_on("kokkos-kernels@3.4.1:5")
    depends_on("hdf5 +mpi")
    depends_on("zlib-api")
    depends_on("metis@5:")
    depends_on("netcdf-c")
    depends_on("seacas ~tests")  # of which the Exodus II library is used
    depends_on("yaml-cpp@0.7:")
    depends_on("cli11@2:")
    depends_on("fmt@9:")
    depends_on("nlohmann-json")
    depends_on("muparser")
    depends_on("googletest +gmock", type="test")

    depends_on("py-numpy", type="run", when="+tools")
    depends_on("py-h5py", type="run", when="+tools")
    depends_on("py-matplotlib", type="run", when="+tools")

    conflicts("%gcc@:11", msg="percuss needs C++20: GCC 12 or Clang 14")
    conflicts("%clang@:13", msg="percuss needs C++20: GCC 12 or Clang 14")

    generator("ninja")

    def cmake_args(self):
        return [
            self.define("PERCUSS_BACKEND", "OpenMP"),
            self.define_from_variant("PERCUSS_NATIVE", "native"),
            self.define_from_variant("PERCUSS_PRECISION", "precision"),
            self.define("BUILD_TESTING", self.run_tests),
        ]
