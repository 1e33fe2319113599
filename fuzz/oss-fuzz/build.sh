#!/bin/bash -eu
# Builds every fuzz target the way OSS-Fuzz and ClusterFuzzLite ask for it: with $CXX and $CXXFLAGS, linked to
# $LIB_FUZZING_ENGINE, into $OUT, each with its seed corpus, dictionary (if it has one) and options. $WORK holds the build.
# FUZZ_TARGETS, when set, names the targets to build, such as "daisy_stream can_stream".

source_dir=${SRC}/trama
build_dir=${WORK}/trama
targets=()
if [ -n "${FUZZ_TARGETS-}" ]; then
    read -ra targets <<< "$FUZZ_TARGETS"
else
    for path in "$source_dir"/fuzz/targets/*.cpp; do targets+=("$(basename "$path" .cpp)"); done
fi

generator=()
if command -v ninja > /dev/null; then generator=(-G Ninja); fi
cmake -S "$source_dir" -B "$build_dir" "${generator[@]}" \
    -DCMAKE_BUILD_TYPE=None -DCMAKE_CXX_COMPILER="$CXX" -DCMAKE_CXX_FLAGS="$CXXFLAGS" \
    -DTRAMA_BUILD_FUZZ=ON -DTRAMA_BUILD_TESTS=OFF -DTRAMA_FUZZ_ENGINE="$LIB_FUZZING_ENGINE"
cmake --build "$build_dir" -j "$(nproc)" --target "${targets[@]/#/fuzz_}"

for target in "${targets[@]}"; do
    name=fuzz_$target
    format=${target%%_*}
    cp "$build_dir/fuzz/$name" "$OUT/"

    # python3 packs them, so that no zip program is needed; the names in the archive are flat, as OSS-Fuzz expects.
    python3 -B - "$OUT/${name}_seed_corpus.zip" "$source_dir" "$target" << 'PACK'
import pathlib, sys, zipfile
archive, source, target = sys.argv[1:]
sys.path.insert(0, f"{source}/fuzz")
from campaign_lib import corpus
with zipfile.ZipFile(archive, "w", zipfile.ZIP_DEFLATED) as seeds:
    for folder in corpus.seed_folders(pathlib.Path(source), target):
        for path in sorted(p for p in folder.rglob("*") if p.is_file()):
            seeds.write(path, f"{folder.name}-{path.name}")
PACK

    dictionary=$source_dir/fuzz/dict/$target.dict
    if [ ! -d "$source_dir/fuzz/corpus/$target" ]; then dictionary=$source_dir/fuzz/dict/$format.dict; fi  # it reads what the format's other targets read
    {
        echo "[libfuzzer]"
        echo "max_len = 4096"
        echo "timeout = 10"
        if [ -f "$dictionary" ]; then echo "dict = $name.dict"; fi
    } > "$OUT/$name.options"
    if [ -f "$dictionary" ]; then cp "$dictionary" "$OUT/$name.dict"; fi
done
