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
    tries = _before(page)
    asked = [_question(one, page, wrong=one in page.wrong) for one in page.questions]
    go = button("Check my answers" if page.stage == "quiz" else "Continue", "answer", "btn primary")
    return element(
        "form", title, tries, *asked, told, element("div", go, class_="row end"), id="questions"
    )


def _before(page: Page) -> str:
    """Return what is to be known before the questions are answered."""
    if page.stage == "after":
        ended = {
            "steps": f"All {page.study.max_steps} actions were used, so the task has ended.",
            "time": "The time was up, so the task has ended.",
        }.get(page.spent)
        note = element("p", text(ended), class_="notice", role="status") if ended else ""
        return note + element("blockquote", text(page.request), class_="asked")
    if page.stage != "quiz" or not page.participant.quiz_tries:
        return ""
    left = page.study.quiz_tries - page.participant.quiz_tries
    last = "This is the last try." if left == 1 else f"There are {left} tries left."
    words = f"Not quite. Read what is said below, and answer again. {last}"
    return element("p", words, class_="notice bad", role="alert")


def outcome(page: Page) -> str:
    """Return how the task came out, where the study tells people."""
    words = "You did what was asked." if page.solved else "What was asked has not been done."
    title = element("h1", text(f"Task {page.place + 1}"))
    go = element("div", button("Continue", "read", "btn primary"), class_="row end")
    return title + element("p", words, class_="notice", role="status") + go


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
    return element(
        "div", low, *points, high, class_="scale", style=f"--n:{question.points}", role="group"
    )


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
