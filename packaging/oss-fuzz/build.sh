#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
# Runs inside OSS-Fuzz's builder, which sets CC, CXX, CFLAGS, CXXFLAGS and LIB_FUZZING_ENGINE.
set -euo pipefail
meson setup build -Dfuzz=true -Dfuzz_engine="$LIB_FUZZING_ENGINE" -Dtools=false -Dsparse=ldl \
    -Db_lundef=false -Dbuildtype=plain
for target in acclaim api bvh c3d csv model mot npy trc; do
    ninja -C build "tests/fuzz/fuzz_$target"
    cp "build/tests/fuzz/fuzz_$target" "$OUT/"
    zip --quiet --junk-paths "$OUT/fuzz_${target}_seed_corpus.zip" "tests/fuzz/corpus/$target/"*
    # Fuzzers run in another image, with the libraries beside them. An RPATH also applies to the libraries that these
    # libraries need; a RUNPATH does not.
    ldd "$OUT/fuzz_$target" | awk '/blas|lapack|tmglib|arpack|ldl|amd|suitesparse|gfortran|quadmath|libz/ {print $3}' |
        xargs -I{} cp -n {} "$OUT/"
    # shellcheck disable=SC2016 # for the loader
    patchelf --force-rpath --set-rpath '$ORIGIN' "$OUT/fuzz_$target"
done
