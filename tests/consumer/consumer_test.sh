#!/bin/sh
# usage: consumer_test.sh SOURCE_DIR BUILD_DIR SCRATCH_DIR
#
# Installs the build into a folder of its own, then configures, builds and runs the examples against it.

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
"$prefix/bin/mirrorball" convert studio --to equirect --size 128 -o "$scratch/room.hdr"
"$scratch/consumer/consumer" "$scratch/room.hdr" teapot "$scratch"
"$prefix/bin/mirrorball" info "$scratch/room.ktx2" | grep -q "cube"
"$prefix/bin/mirrorball" info "$scratch/specular.ktx2" | grep -q "cube"
# A PNG says its width and height in bytes 16 to 23.
test "$(od -An -tx1 -j16 -N8 "$scratch/model.png" | tr -d ' ')" = 00000140000000b4

# Who wants the formulas needs none of the codecs.
cmake -S "$source_dir/examples/formulas" -B "$scratch/formulas" -G Ninja -DCMAKE_PREFIX_PATH="$prefix" \
  -DCMAKE_DISABLE_FIND_PACKAGE_OpenEXR=ON -DCMAKE_DISABLE_FIND_PACKAGE_TBB=ON
cmake --build "$scratch/formulas"
"$scratch/formulas/formulas" >"$scratch/output"
diff - "$scratch/output" <<'END'
+X lies on face 0
glass reflects 0.0400 at normal incidence
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
