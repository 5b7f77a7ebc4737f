#!/bin/bash
# SPDX-License-Identifier: Apache-2.0
# documents.sh DOCS FOLDER: copies the documents for a package, which has no source tree. Links to what the package
# keeps in `examples` lead there; other links out of the documents become plain text.
set -euo pipefail

docs=$1 folder=$2

mkdir -p "$folder"
cp -R "$docs/." "$folder"
while IFS= read -r -d '' document; do
  path=${document#"$folder"/}
  slashes=${path//[^\/]/}
  up=${slashes//\//..\/}  # from the document to the folder of documents
  out=../$up
  sed -E -i \
    -e "s#\]\(${out}packaging/(grafana/|alerts/)?(roomcast\.(toml|json|rules\.yml))\)#](${up}examples/\2)#g" \
    -e "s#\[([^]]*)\]\(${out}[^)]*\)#\1#g" "$document"
done < <(find "$folder" -name '*.md' -print0)
