#!/usr/bin/env bash
# Kills a build at random moments, lets it finish, and compares the package with that of an
# undisturbed build, byte by byte. Our own stages only: the poses are the true ones.
#
# kill_and_resume.sh LUMI DEMO_SCENE.toml [ROUNDS] [SEED]
set -euo pipefail

lumi=$1
demo_scene=$2
rounds=${3:-12}
RANDOM=${4:-7}

folder=$(mktemp -d "${TMPDIR:-/tmp}/lumi kill XXXXXX")
trap 'rm -rf "$folder"' EXIT

now_ms() { echo $(($(date +%s%N) / 1000000)); }

fail() {
    echo "FAILED: $*" >&2
    exit 1
}

make_scene() {
    sed -e 's/^width_px = .*/width_px = 192/' -e 's/^height_px = .*/height_px = 128/' \
        -e 's/^focal_length_px = .*/focal_length_px = 200/' -e 's/^count = .*/count = 8/' \
        -e 's/^rows = .*/rows = 2/' -e 's/^start_at = .*/start_at = 0/' \
        "$demo_scene" >"$folder/scene.toml"
    "$lumi" synth -q "$folder/scene.toml" --out "$folder/scene" >/dev/null
    cat >"$folder/small.toml" <<TOML
name = "small"
[capture]
photos = "scene/photos"
import = "scene/truth/sparse"
[depth]
max_width_px = 64
[render] # Nothing that photographs are asked for: most of a build is then reading and writing.
depth_views = 4
depth_block_px = 1
fill_holes = "no"
check_guesses = "no"
draw_thin = "no"
triangle_error_px = 0.7
occlusion_tolerance_px = 1.5
noisy_depth_error_px = 1.6
TOML
}

build() { "$lumi" build -q "$folder/small.toml" --workspace "$1" >/dev/null; }

# Starts a build and kills it after at most $2 milliseconds; true when it was still running.
build_and_kill() {
    "$lumi" build -q "$folder/small.toml" --workspace "$1" >/dev/null 2>&1 &
    local child=$!
    local delay_ms=$((RANDOM * $2 / 32768))
    sleep "$(printf '%d.%03d' $((delay_ms / 1000)) $((delay_ms % 1000)))"
    kill -9 "$child" 2>/dev/null || return 1
    wait "$child" 2>/dev/null || true
}

leftovers() { find "$1" -maxdepth 1 -name '.*.new-*'; }

make_scene
start_ms=$(now_ms)
build "$folder/undisturbed"
duration_ms=$(($(now_ms) - start_ms))

killed=0
for round in $(seq "$rounds"); do
    work="$folder/work $round"
    for _ in 1 2; do
        if build_and_kill "$work" "$duration_ms"; then killed=$((killed + 1)); fi
        if [ -d "$work/small.lumi" ]; then
            "$lumi" validate -q "$work/small.lumi" >/dev/null || fail "round $round: half a package"
        fi
    done
    build "$work" || fail "round $round: the build did not resume"
    diff -r "$folder/undisturbed/small.lumi" "$work/small.lumi" || fail "round $round: other bytes"
    [ -z "$(leftovers "$work")" ] || fail "round $round: left behind: $(leftovers "$work")"
done
[ "$killed" -gt 0 ] || fail "no build was killed: the moments were too late"
echo "$killed builds killed in $rounds rounds of about $duration_ms ms; every package is the same"
