"""Choosing among texts token by token: the tree of their tokens, and a greedy walk down it."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field

from reibench.backends import Alternative

END = -1
"""Stands, among a node's children, for the option that ends there."""

RUNNER_UP = 0.1
"""A branch not taken is looked into if it was at least this probable: that costs one question."""

MOST = 5
"""Alternatives listed."""

OPTION_ENDS = (",", ".", "\n")
"""What may follow a whole option, where another option goes on."""

Ask = Callable[[tuple[int, ...], Sequence[int]], Mapping[int, float]]
"""Given the tokens so far and those that may follow, how probable is each of these?"""


@dataclass
class Node:
    """A place in the tree of the options' tokens."""

    ends: tuple[int, ...]
    """Tokens any of which says that an option is over, where another goes on."""
    option: str = ""
    """The option that is complete here, if one is."""
    children: dict[int, "Node"] = field(default_factory=dict)

    @property
    def choices(self) -> tuple[int, ...]:
        """Tokens that may follow here, with `END` if an option may end here."""
        return (*self.children, END) if self.option else tuple(self.children)


def inside_line(text: str, tokenize: Callable[[str], tuple[int, ...]]) -> tuple[int, ...]:
    """Return the tokens of `text` as they are inside a line, not at the start of one."""
    before, whole = tokenize("a"), tokenize("a" + text)
    inside = whole[: len(before)] == before and len(whole) > len(before)
    return whole[len(before) :] if inside else tokenize(text)


def grow(options: Mapping[str, Sequence[int]], ends: tuple[int, ...]) -> Node:
    """Build the tree of `options`, each given with its tokens."""
    root = Node(ends)
    for option, tokens in options.items():
        node = root
        for token in tokens:
            node = node.children.setdefault(token, Node(ends))
        node.option = option
    return root


@dataclass(frozen=True)
class Branch:
    """A place in the tree and how probable it is to get there."""

    path: tuple[int, ...]
    node: Node
    probability: float
    over: bool = False
    """Whether the option that ends at `node` is meant, not what goes on from it."""

    def follow(self, token: int, share: float = 1.0) -> "Branch":
        """Take one of the node's choices, and go on as far as there is none to make."""
        probability = self.probability * share
        if token == END:
            return Branch(self.path, self.node, probability, over=True)
        return Branch((*self.path, token), self.node.children[token], probability).forced()

    def forced(self) -> "Branch":
        """Go on as far as there is no choice to make."""
        here = self.node.choices
        return self.follow(here[0]) if len(here) == 1 and not self.over else self


class Walk:
    """One walk from the root to an option, asking only where options part."""

    def __init__(self, ask: Ask) -> None:
        self.tokens: tuple[int, ...] = ()
        """The chosen option's tokens."""
        self._ask = ask
        self._passed: list[Branch] = []
        self._reached: dict[str, float] = {}

    def greedy(self, root: Node) -> str:
        """Return the option reached by taking the likeliest token at every parting."""
        end = self._descend(Branch((), root, 1.0).forced())
        self.tokens = end.path
        return end.node.option

    def alternatives(self, chosen: str) -> tuple[Alternative, ...]:
        """Return the likeliest options looked into, likeliest first, `chosen` among them.

        Looks into the likeliest branch that was not taken, if it was likely enough. Options behind
        other branches are less probable than that branch and are not listed.
        """
        runner_up = max(self._passed, key=lambda branch: branch.probability, default=None)
        if runner_up and runner_up.probability >= RUNNER_UP:
            self._descend(runner_up)
        ranked = sorted(self._reached, key=lambda text: -self._reached[text])
        kept = [text for text in ranked[:MOST] if text != chosen][: MOST - 1]
        listed = sorted((*kept, chosen), key=ranked.index)
        return tuple(Alternative(text, self._reached[text]) for text in listed)

    def _descend(self, branch: Branch) -> Branch:
        while not branch.over:
            branch, *others = self._weigh(branch)
            for other in others:
                if other.over:
                    self._reached[other.node.option] = other.probability
                else:
                    self._passed.append(other)
        self._reached[branch.node.option] = branch.probability
        return branch

    def _weigh(self, branch: Branch) -> list[Branch]:
        """Return what may follow, the likeliest first (at a tie, the earlier option)."""
        node = branch.node
        weights = self._ask(branch.path, (*node.children, *(node.ends if node.option else ())))
        shares = {token: weights.get(token, 0.0) for token in node.children}
        if node.option:
            shares[END] = sum(weights.get(token, 0.0) for token in node.ends)
        ranked = sorted(shares, key=lambda token: -shares[token])
        return [branch.follow(token, shares[token]) for token in ranked]
