"""The walk over the tree of the options' tokens, with probabilities made up."""

from reibench.backends.walk import Walk, grow

THINGS = {"a cat": (1, 2), "a car": (1, 3), "the cat": (4, 2), "a car park": (1, 3, 5)}
COMMA = 9


def asking(weights, asked):
    def ask(path, tokens):
        asked.append(path)
        return {token: weights.get((*path, token), 0.0) for token in tokens}

    return ask


def test_it_asks_only_where_options_part():
    asked = []
    tree = grow({"open the fridge": (1, 2, 3), "open the box": (1, 2, 4)}, (COMMA,))
    assert Walk(asking({(1, 2, 3): 0.2, (1, 2, 4): 0.8}, asked)).greedy(tree) == "open the box"
    assert asked == [(1, 2)]


def test_a_single_option_needs_no_question():
    walk = Walk(asking({}, asked := []))
    assert walk.greedy(grow({"done": (7,)}, (COMMA,))) == "done"
    assert (walk.tokens, asked) == ((7,), [])


def test_it_is_greedy_though_another_option_is_likelier_as_a_whole():
    weights = {(1,): 0.6, (4,): 0.4, (1, 2): 0.5, (1, 3): 0.5, (1, 3, COMMA): 1.0}
    walk = Walk(asking(weights, []))
    assert walk.greedy(grow(THINGS, (COMMA,))) == "a cat"
    assert [one.text for one in walk.alternatives("a cat")][:2] == ["the cat", "a cat"]


def test_what_follows_a_whole_option_decides_whether_it_goes_on():
    tree = grow(THINGS, (COMMA,))
    start = {(1,): 1.0, (1, 3): 1.0}
    assert Walk(asking(start | {(1, 3, COMMA): 0.7, (1, 3, 5): 0.3}, [])).greedy(tree) == "a car"
    walk = Walk(asking(start | {(1, 3, COMMA): 0.3, (1, 3, 5): 0.7}, []))
    assert walk.greedy(tree) == "a car park"
    assert walk.tokens == (1, 3, 5)


def test_an_unlikely_branch_is_not_looked_into():
    asked = []
    weights = {(1,): 0.95, (4,): 0.05, (1, 2): 0.9, (1, 3): 0.1}
    tree = grow({"a cat": (1, 2), "a car": (1, 3), "the cat": (4, 2), "the dog": (4, 6)}, (COMMA,))
    walk = Walk(asking(weights, asked))
    listed = walk.alternatives(walk.greedy(tree))
    assert [one.text for one in listed] == ["a cat", "a car"]
    assert asked == [(), (1,)]
