"""What the browser sends is read once, and nothing odd gets further."""

from reibench.pages.asking import Ask, visitor_token


def test_an_event_is_read_field_by_field():
    ask = Ask.read(
        {"seq": 3, "episode": "a.b", "actor": "tocc", "expected": 7, "seconds": 1.5, "as": "side"}
    )
    assert (ask.seq, ask.episode, ask.actor, ask.expected) == (3, "a.b", "tocc", 7)
    assert (ask.seconds, ask.as_actor) == (1.5, "side")


def test_anything_odd_counts_as_not_given():
    for sent in (None, 7, "x", {"actor": "root", "expected": "7", "seconds": -1, "method": "x"}):
        ask = Ask.read(sent)
        assert (ask.actor, ask.expected, ask.seconds, ask.method) == ("me", 0, None, "")
    assert len(Ask.read({"skill": "x" * 5000}).skill) == 200


def test_no_method_is_none_to_be_compared_with():
    assert Ask.read({"actor": "side", "method": "ap"}).method == "ap"
    assert Ask.read({"actor": "side", "method": "none"}).method == ""


def test_a_browser_keeps_its_token_and_a_forged_one_is_replaced():
    token = visitor_token("")
    assert visitor_token(token) == token
    assert visitor_token("admin") != "admin"
    assert visitor_token(None) != visitor_token(None)
