# Sourced by each example's run: builds the program NAME of examples/NAME and starts it with the arguments behind it.
#
#   here=$PWD; source examples/common/start.sh NAME "$@"
name=$1
shift
need g++ cmake ninja-build
echo "Building $name in build/examples" >&2
# One at a time: a second example may be started in another terminal meanwhile.
mkdir -p build
exec 9> build/examples.lock
if command -v flock > /dev/null; then flock 9; fi
drop_foreign build/examples
quietly cmake -S . -B build/examples -G Ninja -DTRAMA_BUILD_EXAMPLES=ON -DTRAMA_BUILD_TOOL=OFF || die "it cannot be configured"
quietly cmake --build build/examples -j "$jobs" --target "$name" || die "the build failed"
program=$top/build/examples/examples/$name/$name
cd "$here" || exit
exec 9>&-
exec "$program" "$@"
