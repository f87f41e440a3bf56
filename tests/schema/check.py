# SPDX-License-Identifier: MIT
"""Does the JSON schema accept what it should, and nothing else?

usage: check.py SCHEMA ROOT CASES

Validates every scenario, package and data file below ROOT against SCHEMA, and then each line of
CASES, "accept PATH=VALUE" or "refuse PATH=VALUE", set in base.yaml beside CASES. Prints what is wrong; exit
code 1 if anything is.
"""
import copy
import glob
import json
import os
import re
import sys

import jsonschema
import yaml


class Yaml12(yaml.SafeLoader):
    """PyYAML reads YAML 1.1, where `1e-6` is a text and `on` is true; editors and Eyrie read 1.2."""


Yaml12.yaml_implicit_resolvers = {}
for tag, pattern, first in [
    ("null", r"~|null|Null|NULL|", ["~", "n", "N", ""]),
    ("bool", r"true|True|TRUE|false|False|FALSE", list("tTfF")),
    ("int", r"[-+]?[0-9]+", list("-+0123456789")),
    ("float", r"[-+]?(\.[0-9]+|[0-9]+(\.[0-9]*)?)([eE][-+]?[0-9]+)?", list("-+.0123456789")),
]:
    Yaml12.add_implicit_resolver("tag:yaml.org,2002:" + tag, re.compile(f"^(?:{pattern})$"), first)
Yaml12.add_constructor("!tree", lambda loader, node: {"tree": loader.construct_scalar(node)})


def read(path):
    with open(path, encoding="utf-8") as file:
        return yaml.load(file, Yaml12)


def mistakes(schema, document):
    found = jsonschema.Draft7Validator(schema).iter_errors(document)
    return [f"{'/'.join(map(str, e.absolute_path))}: {e.message[:300]}" for e in found]


def set_value(document, assignment):
    """As --set: keys, indices, and the names of players."""
    path, value = assignment.split("=", 1)
    *way, last = path.split(".")
    at = document
    for key in way:
        at = at[int(key)] if isinstance(at, list) else at[key]
    last = int(last) if isinstance(at, list) else last
    at[last] = yaml.load(value, Yaml12)


def main():
    schema_file, root, cases = sys.argv[1:]
    with open(schema_file, encoding="utf-8") as file:
        schema = json.load(file)
    jsonschema.Draft7Validator.check_schema(schema)
    part = lambda name: {"$ref": "#/definitions/" + name, "definitions": schema["definitions"]}
    bad = []

    files = [(f, schema) for f in glob.glob(root + "/scenarios/**/*.yaml", recursive=True)]
    files += [(f, part("model." + os.path.basename(os.path.dirname(f))))
              for f in glob.glob(root + "/data/*/*.yaml")]
    if len({id(s) for _, s in files}) < 3:
        bad.append("no scenarios or data below " + root)
    for file, its_schema in sorted(files, key=lambda pair: pair[0]):
        bad += [f"{file}: {said}" for said in mistakes(its_schema, read(file))]

    base = read(os.path.join(os.path.dirname(cases), "base.yaml"))
    bad += [f"base.yaml: {said}" for said in mistakes(schema, base)]
    with open(cases, encoding="utf-8") as file:
        lines = [line.rstrip("\n") for line in file if line.strip() and not line.startswith("#")]
    for line in lines:
        verdict, assignment = line.split(" ", 1)
        document = copy.deepcopy(base)
        set_value(document, assignment)
        said = mistakes(schema, document)
        if (verdict == "accept") != (not said):
            bad.append(f"should {verdict}: {assignment}" + "".join("\n  " + s for s in said[:1]))
    print("\n".join(bad) or f"{len(files)} files and {len(lines)} cases")
    return 1 if bad else 0


sys.exit(main())
