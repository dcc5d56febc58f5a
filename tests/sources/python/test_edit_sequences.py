"""Changes one after the other, in every node of the collection."""

from __future__ import annotations

from collections import Counter

from edits import (
    AT,
    CATALOGS,
    DIALECTS,
    NODES,
    provide,
    publish,
    request,
    subscribe,
)
from file_sets import one
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from machine import examples

from plastron_tui.model.kinds import EDITABLE, kind_of
from plastron_tui.model.source import Add, EndpointKind, Remove, Update
from plastron_tui.sources.python import edit_python, read_python


def test_no_change_is_the_same_file():
    for path in NODES:
        data = path.read_bytes()
        source = read_python(path, one(data)).source
        if source is not None:
            library = source.library
            assert edit_python(source, [], CATALOGS[library], DIALECTS[library]).files == one(data)


CHANGES = st.sampled_from(
    [
        publish("new_a"),
        publish("new_b", data='it\'s "so"\n'),
        publish("new_pose", "geometry_msgs/PoseStamped"),
        subscribe("new_c", "std_msgs/Int32"),
        provide("new_d"),
        request("new_e", "std_srvs/SetBool", data=True),
    ]
)


def names(source) -> Counter:
    return Counter(
        (found.kind, found.name if found.name is not None else found.expression)
        for node in source.nodes
        for found in node.endpoints
        if found.kind is not EndpointKind.TIMER
    )


@settings(max_examples=examples(60), deadline=None, suppress_health_check=[HealthCheck.too_slow])
@given(st.sampled_from(NODES), st.lists(CHANGES, max_size=4, unique_by=id), st.randoms())
def test_any_sequence_gives_the_endpoints_that_it_asks_for(path, additions, random):
    """Each step starts from the text of the one before, as load and generate do."""
    source = read_python(path, one(path.read_bytes())).source
    if source is None:
        return
    expected = names(source)
    library = source.library
    for addition in additions:
        choice = [key for key in expected if key[0] in EDITABLE]
        change = addition
        if choice and random.random() < 0.5:
            kind, name = random.choice(choice)
            change = Remove(kind, name, AT)
            if kind_of(type(addition.endpoint)) is kind:
                change = Update(kind, name, addition.endpoint, AT)
        rendered = edit_python(source, [change], CATALOGS[library], DIALECTS[library])
        if rendered.files is None:
            assert rendered.diagnostics
            continue
        had = expected[change.kind, change.name] if not isinstance(change, Add) else 0
        if had:
            expected[change.kind, change.name] = 0
        result = read_python(path, rendered.files, library)
        assert result.source is not None
        source = result.source
        if not isinstance(change, Remove):
            endpoint = change.endpoint
            key = kind_of(type(endpoint)), endpoint.name
            # An update changes each of several calls of a name, or writes one anew.
            is_each = isinstance(change, Update) and names(source)[key] - expected[key] == had
            expected[key] += had if is_each else 1
        assert names(source) == +expected
