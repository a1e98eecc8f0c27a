# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 The Setae authors
#
# What prm/run, tests/run and benchmarks/run share: packages, configuration,
# build and the environment of MPI. To be sourced by bash.
# shellcheck shell=bash

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=$root/build/release

say() { printf -- '-- %s\n' "$*"; }

die() {
  printf 'Error: %s\n' "$*" >&2
  exit 1
}

# Whether what a Debian package is needed for is there, from wherever it came.
have() {
  case $1 in
    libdeal.ii-dev)
      [[ -n ${DEAL_II_DIR:-} ||
        -e /usr/share/cmake/deal.II/deal.IIConfig.cmake ]]
      ;;
    libgtest-dev) [[ -e /usr/include/gtest/gtest.h ]] ;;
    libbenchmark-dev) [[ -e /usr/include/benchmark/benchmark.h ]] ;;
    ninja-build) command -v ninja >/dev/null ;;
    gnuplot-nox) command -v gnuplot >/dev/null ;;
    python3-matplotlib) /usr/bin/python3 -c 'import matplotlib' 2>/dev/null ;;
    *) command -v "$1" >/dev/null ;;
  esac
}

why() {
  case $1 in
    libdeal.ii-dev) echo "finite elements, Trilinos, MPI" ;;
    g++) echo "compiler" ;;
    cmake | ninja-build) echo "build" ;;
    git) echo "revision printed by the program" ;;
    libgtest-dev) echo "unit tests" ;;
    numdiff) echo "comparison of the output of whole runs" ;;
    gnuplot-nox) echo "plots of the benchmarks" ;;
    python3-matplotlib) echo "plots of runs" ;;
    libbenchmark-dev) echo "timings of kernels" ;;
  esac
}

# need PACKAGE...: install those of the Debian packages that are missing.
need() {
  local package missing=() as_root=()
  for package in libdeal.ii-dev g++ cmake ninja-build git "$@"; do
    have "$package" || missing+=("$package")
  done
  ((${#missing[@]})) || return 0

  command -v apt-get >/dev/null ||
    die "please install these packages (Debian names): ${missing[*]}"
  if ((EUID != 0)); then
    command -v sudo >/dev/null ||
      die "please install these Debian packages as root: ${missing[*]}"
    as_root=(sudo)
  fi

  say "Installing what is missing (some minutes for deal.II):"
  for package in "${missing[@]}"; do
    say "  $package: $(why "$package")"
  done
  "${as_root[@]}" apt-get -q update ||
    say "The package lists could not be refreshed; trying with the old ones."
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
    apt-get -q -y --no-install-recommends install "${missing[@]}" ||
    die "apt-get could not install ${missing[*]}."
}

# A compiler that includes deal.II takes up to 1.5 GB. nproc would answer with
# OMP_NUM_THREADS if that is set.
jobs_that_fit() {
  local cores memory
  cores=$(env -u OMP_NUM_THREADS nproc)
  memory=$(awk '/^MemAvailable/ {print int($2 / 1500000)}' /proc/meminfo)
  ((memory < cores)) && cores=$memory
  ((cores > 0)) || cores=1
  echo "$cores"
}

# build_targets TARGET...: configure and build what is not up to date. The lock
# keeps two scripts from building in the same folder at the same time.
build_targets() {
  local jobs
  jobs=${CMAKE_BUILD_PARALLEL_LEVEL:-$(jobs_that_fit)}
  mkdir -p "$build"
  (
    flock 9

    # A clone that was moved or copied carries a folder CMake refuses.
    if [[ -e $build/CMakeCache.txt ]] &&
      ! grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$build/CMakeCache.txt"
    then
      find "$build" -mindepth 1 ! -name .lock -delete
    fi

    local generator=()
    [[ -e $build/CMakeCache.txt ]] || generator=(-G Ninja)
    if ! cmake -S "$root" -B "$build" "${generator[@]}" \
      -DCMAKE_BUILD_TYPE=Release >"$build/configure.log" 2>&1; then
      cat "$build/configure.log" >&2
      die "the configuration failed."
    fi

    say "Building $* (Release, $jobs at a time)"
    cmake --build "$build" --parallel "$jobs" --target "$@" ||
      die "the build failed."
  ) 9>"$build/.lock"
}

# Ranks are the only parallelism; Open MPI refuses root and more ranks than
# cores, as found in containers, unless told otherwise, and its ranks do not give
# way to each other while they wait.
export DEAL_II_NUM_THREADS=${DEAL_II_NUM_THREADS:-1}
export OMP_NUM_THREADS=${OMP_NUM_THREADS:-1}
export OMPI_MCA_rmaps_base_oversubscribe=1
export OMPI_MCA_mpi_yield_when_idle=1
if ((EUID == 0)); then
  export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
fi
