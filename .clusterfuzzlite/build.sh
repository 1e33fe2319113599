#!/bin/bash -eu
# The same build as OSS-Fuzz's.
exec "$SRC/trama/fuzz/oss-fuzz/build.sh"
