#!/bin/sh
# usage: consumer_test.sh SOURCE_DIR BUILD_DIR SCRATCH_DIR
#
# Installs the build into a folder of its own, then configures, builds and runs examples/consumer against it.

set -eu
source_dir=$1
build=$2
scratch=$3
prefix=$scratch/prefix

rm -rf "$scratch"
cmake --install "$build" --prefix "$prefix" >/dev/null
"$prefix/bin/mirrorball" --version
test -s "$prefix/share/doc/mirrorball/LICENSE"
for page in man/man1/mirrorball.1 bash-completion/completions/mirrorball zsh/site-functions/_mirrorball \
  fish/vendor_completions.d/mirrorball.fish; do
  test -s "$prefix/share/$page"
done

cmake -S "$source_dir/examples/consumer" -B "$scratch/consumer" -G Ninja -DCMAKE_PREFIX_PATH="$prefix"
cmake --build "$scratch/consumer"
"$scratch/consumer/consumer" "$scratch/cross.exr" >"$scratch/output"
diff - "$scratch/output" <<'END'
cross: 128 x 96, front 1 1 1
+X lies on face 0
glass reflects 0.0400 head on
END

cmake -S "$source_dir/tests/consumer/headers" -B "$scratch/headers" -G Ninja -DCMAKE_PREFIX_PATH="$prefix" \
  -DMIRRORBALL_INCLUDE_DIR="$prefix/include/mirrorball"
cmake --build "$scratch/headers"

# Nothing installed may lead back to the build or to the sources.
if grep -rlF -e "$source_dir/src" -e "$build/" "$prefix/lib/" --include='*.cmake'; then
  echo "FAILED: the package names folders of the build"
  exit 1
fi
rm -rf "$scratch"
