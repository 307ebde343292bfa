#!/bin/sh
# SPDX-FileCopyrightText: 2026 Spindrift contributors
# SPDX-License-Identifier: Apache-2.0
# Takes the strings of the sources into the translation files.
#   translations/update.sh          updates translations/spindrift_*.ts
#   translations/update.sh --check  changes nothing; fails if a string is new, gone or not translated
# Texts of the property tables and the plugins are marked SPIN_TR("..."); they are gathered under the context "Properties".
set -eu
cd "$(dirname "$0")/.."
lupdate=${LUPDATE:-/usr/lib/qt6/bin/lupdate}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

mkdir "$work/sources"
perl -0777 -ne 'while (/SPIN_TR\(\s*((?:"(?:[^"\\]|\\.)*"\s*)+)\)/g) {
    my $text = $1;
    $text =~ s/"\s+"//g;
    $text =~ s/\s+$//;
    print "const char* text$. = QT_TRANSLATE_NOOP(\"Properties\", $text);\n";
  }' $( (find core -name '*.cpp'; find plugins -name '*.cpp' -o -name '*.h') | LC_ALL=C sort) > "$work/sources/properties.cpp"

status=0
for file in translations/spindrift_*.ts; do
  name=$(basename "$file")
  cp "$file" "$work/$name"
  only=
  # English needs its plural forms only; the texts themselves stand in the sources.
  if [ "$name" = spindrift_en.ts ]; then only=-pluralonly; fi
  "$lupdate" -silent $only -locations none -no-obsolete -no-ui-lines -I . editor "$work/sources/properties.cpp" -ts "$work/$name" 2> "$work/messages" || { cat "$work/messages" >&2; exit 1; }
  if [ "${1:-}" = "--check" ]; then
    if ! cmp -s "$file" "$work/$name"; then
      echo "$file is not up to date; run translations/update.sh and translate what is new:" >&2
      diff "$file" "$work/$name" | head -20 >&2 || true
      status=1
    fi
    if grep -q 'type="unfinished"\|type="vanished"\|type="obsolete"' "$file"; then
      echo "$file has unfinished strings:" >&2
      grep -B 3 'type="unfinished"' "$file" | grep '<source>' | head -20 >&2 || true
      status=1
    fi
  else
    cp "$work/$name" "$file"
  fi
done
exit $status
