#!/bin/sh
# Bytes of memory for each triangle, sphere, copy and child: the largest resident size of a run less that of the same scene with one of them.
#   bench/memory.sh [lute]
lute=${1:-build/bin/lute}
scenes=$(dirname "$0")/memory
out=$(mktemp)
trap 'rm -f "$out"' EXIT

# kilobytes and seconds of processor time
run() {
  scene=$1
  shift
  /usr/bin/time -f '%M %U' -o "$out" "$lute" "+I$scenes/$scene.pov" +W160 +H120 -A +WT1 -D -F "$@" >/dev/null 2>&1
  cat "$out"
}

row() {
  what=$1 scene=$2 count=$3 few=$4 many=$5
  less=$(run "$scene" "$few")
  more=$(run "$scene" "$many")
  echo "$less $more $count $what" | awk '{ bytes = ($3 - $1) * 1024 / $5; kilo = $3; seconds = $4; count = $5;
    $1 = $2 = $3 = $4 = $5 = ""; sub(/^ +/, ""); printf "| %s | %d | %.0f MB | %.0f | %.2f s |\n", $0, count, kilo / 1024, bytes, seconds }'
}

echo '| what | how many | in all | bytes each | processor time |'
echo '|---|---:|---:|---:|---:|'
row 'triangles of a mesh2, with normals and uv' mesh 1002528 Declare=Side=1 Declare=Side=708
row 'spheres, objects of their own' spheres 100000 Declare=Count=1 Declare=Count=100000
row 'spheres, each with a pigment of its own' colored_spheres 100000 Declare=Count=1 Declare=Count=100000
row 'copies of a mesh of 5,000 triangles' copies 1000000 Declare=Count=1 Declare=Count=1000000
row 'children of a difference' children 1024 Declare=Side=1 Declare=Side=32
row 'children of a difference' children 10000 Declare=Side=1 Declare=Side=100
row 'children of a difference' children 99856 Declare=Side=1 Declare=Side=316
row 'levels of nesting' depth 100 Declare=Depth=2 Declare=Depth=100
