"""Questions and buttons as participants get them."""

from reibench.household import load_room
from reibench.skill import in_words
from reibench.view.markup import element, text
from study.config import Question
from study.stages import Page


def button(words: str, what: str, kind: str) -> str:
    """Return a button that does `what`."""
    return element("button", text(words), type="button", class_=kind, data_do=what)


def form(page: Page, told: str) -> str:
    """Return the questions of a stage; `told` is what was wrong with the answers, as markup."""
    titles = {"quiz": "A few questions about the instructions", "after": "About this task"}
    title = element("h1", text(titles.get(page.stage, "Last questions")))
    tries = ""
    if page.stage == "quiz" and page.participant.quiz_tries:
        tries = element(
            "p",
            "Not quite. Read what is said below, and try once more.",
            class_="notice",
            role="alert",
        )
    told = _outcome(page) + told
    asked = [_question(one, page, wrong=one in page.wrong) for one in page.questions]
    go = button("Check my answers" if page.stage == "quiz" else "Continue", "answer", "btn primary")
    return element(
        "form", title, tries, *asked, told, element("div", go, class_="row end"), id="questions"
    )


def _outcome(page: Page) -> str:
    """Return how the task came out, where the study tells people."""
    if page.solved is None:
        return ""
    words = "You did what was asked." if page.solved else "What was asked has not been done."
    return element("p", words, class_="notice", role="status")


def _question(question: Question, page: Page, *, wrong: bool) -> str:
    legend = element("legend", text(question.text))
    why = element("p", text(question.why), class_="notice") if wrong and question.why else ""
    if question.kind == "text":
        field = element(
            "textarea", "", name=question.name, rows=4, maxlength=2000, aria_label=question.text
        )
        optional = element("p", "You may leave this empty.", class_="small muted")
        return element("fieldset", legend, optional if question.optional else "", field)
    if question.kind == "object":
        return element("fieldset", legend, _objects(question, page))
    if question.kind == "scale":
        return element("fieldset", legend, _scale(question))
    answers = [_radio(question.name, option, option) for option in question.options]
    return element("fieldset", legend, *answers, why)


def _radio(name: str, value: str, words: str) -> str:
    box = element("input", type="radio", name=name, value=value)
    return element("label", box, text(words), class_="answer")


def _scale(question: Question) -> str:
    ends = question.options
    points = [_radio(question.name, str(n), str(n)) for n in range(1, question.points + 1)]
    low, high = element("span", text(ends[0])), element("span", text(ends[-1]))
    return element("div", low, *points, high, class_="scale")


def _objects(question: Question, page: Page) -> str:
    """Return a choice among the kinds of things in the room, in alphabetical order."""
    room = load_room(page.room)
    names = sorted({in_words(thing.type): thing.type for thing in room.objects}.items())
    options = [element("option", "Choose …", value="")] + [
        element("option", text(words), value=name) for words, name in names
    ]
    return element(
        "select", *options, name=question.name, class_="native", aria_label=question.text
    )
