# Shared by the scripts beside it; to be sourced.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
jobs=${JOBS:-$(nproc)} # each compiler takes up to 2 GB of memory
# Compiles the programs before the library that they are linked to is there, and starts at once where all is done. Folders
# that were made for something else stay so.
export CMAKE_GENERATOR=${CMAKE_GENERATOR:-Ninja}
# For CMake: where CGAL is, or that the place used last is to be forgotten.
cgal_option=-UCGAL_DIR
if [[ -n ${CGAL_DIR:-} ]]; then
  cgal_option=-DCGAL_DIR=$CGAL_DIR
fi

# Installs those of the given Debian packages that are missing.
install_missing()
{
  local package missing=()
  for package in "$@"; do
    if [[ $(dpkg-query -W -f '${Status}' "$package" 2>/dev/null) != "install ok installed" ]]; then
      missing+=("$package")
    fi
  done
  if [[ ${#missing[@]} -eq 0 ]]; then
    return
  fi

  local as_root=()
  if [[ $(id -u) -ne 0 ]]; then
    as_root=(sudo)
  fi
  echo "installing ${missing[*]}"
  "${as_root[@]}" apt-get update -qq
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}" \
    >/dev/null
}

# What compiling the package takes.
build_packages=(g++ make ninja-build cmake libcgal-dev libboost-dev libeigen3-dev libgmp-dev libmpfr-dev)
# What sub-domains are divided by, and meshed at the same time with; what mesh_surface_mpi takes.
subdomain_packages=(libtbb-dev libmetis-dev)
mpi_packages=(libboost-mpi-dev openmpi-bin libopenmpi-dev)

# What the programs read their arguments with.
program_packages=(libcli11-dev)

# What the Python module takes, and its tests, and for CMake the Python that has them.
python_build_packages=(pybind11-dev python3-dev)
python_packages=("${python_build_packages[@]}" python3-numpy python3-scipy python3-meshio python3-vtk9 xvfb xauth)
with_python=(-DBR3_BUILD_PYTHON=ON -DPython_EXECUTABLE=/usr/bin/python3)

# Clang, and the linker that goes with it, which needs a fifth of the time of that of GCC.
clang_packages=(clang lld)
# For CMake, which takes the name of precompiled headers of C++ from the compiler of C.
with_clang=(-DCMAKE_C_COMPILER=clang -DCMAKE_CXX_COMPILER=clang++)
for kind in EXE SHARED MODULE; do
  with_clang+=("-DCMAKE_${kind}_LINKER_FLAGS=-fuse-ld=lld")
done
