"""What is known of a form: whether it was filled in, and what a trial of another text keeps."""

from __future__ import annotations

from plastron_tui.language import DECLARATIONS
from plastron_tui.language import statements as st
from plastron_tui.studio.wizard.form import NEW, Form


def sending() -> Form:
    """Return a form that sends a message, with the form that makes the message."""
    form = Form(DECLARATIONS[st.Publish], drives=True)
    form.makers["message"] = Form(DECLARATIONS[st.CreateMessage], parent=(form, "message"))
    return form


def test_what_is_written_in_a_form_that_is_needed_counts() -> None:
    form = sending()
    assert not form.is_filled_in
    form.makers["message"].put("input", ("data",), "hello")
    assert form.is_filled_in and not Form(form.declaration).is_filled_in
    form = sending()
    form.put("topic", None, "chatter")
    assert form.is_filled_in and form.entered == {"topic": "chatter"}


def test_a_trial_keeps_all_but_what_is_tried() -> None:
    form = sending()
    form.given["node"] = "talker"
    form.put("message", None, NEW)
    maker = form.makers["message"]
    maker.given["type"] = "std_msgs/String"
    maker.put("input", ("data",), "hello")
    tried = form.trial("topic", "chatter", {}, frozenset())
    assert (tried.given, tried.drives) == (form.given, True)
    assert tried.entered == {"message": NEW, "topic": "chatter"}
    copy = tried.makers["message"]
    assert (copy.given, copy.values, copy.parent) == (maker.given, maker.values, (tried, "message"))
    # Whatever is done with the trial, the form stays as it is.
    copy.given.clear()
    copy.values.clear()
    tried.given.clear()
    assert maker.given and maker.values and form.given and form.entered == {"message": NEW}
    assert form.trial("topic", "chatter", {}, frozenset({"message"})).makers == {}
