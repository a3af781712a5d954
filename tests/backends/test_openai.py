"""Models behind OpenAI-compatible servers: llama.cpp's own, and one that goes wrong on purpose."""

import logging
from concurrent.futures import ThreadPoolExecutor
from threading import Lock

import pytest

from reibench import models
from reibench.backends import Prompt, is_concurrent
from reibench.backends.openai import Connection
from reibench.backends.opening import open_backend
from reibench.backends.patience import Patience
from reibench.backends.prices import price_of
from reibench.backends.remote import RemoteModel
from reibench.errors import ModelUnavailable, ReibenchError, UnknownName
from reibench.rollout import Rollout
from reibench.run import RunSpec, evaluate, play
from reibench.skill import SKILLS
from reibench.worlds import worlds
from tests.backends.faulty import KEY, Reply, error, model_of, obliging, said, serving

OPTIONS = [" find a mug", " find a pan", " done"]
EXAMPLES = "\n".join(
    f"Human: Bring me the {thing}.\nRobot: find a {thing}, pick up the {thing}, done"
    for thing in ("mug", "vase", "book", "pillow", "laptop", "statue")
)


@pytest.fixture(scope="session")
def llama_server():
    """Serve the packaged Gemma by llama.cpp's own server, as `llama-server` does."""
    from xllamacpp import CommonParams, Server

    params = CommonParams()
    params.model.path = str(models.path_of("gemma-3-270m"))
    params.n_parallel = 8
    params.n_ctx = 8 * 3072
    params.cpuparams.n_threads = 2
    params.warmup = False
    params.swa_full = True
    params.cache_ram_mib = 0
    params.verbosity = -1
    server = Server(params)
    server.handle_completions({"prompt": "a", "n_predict": 1})
    return server


@pytest.fixture
def served(llama_server, monkeypatch):
    """Open it by its name, with a proxy set that leads nowhere."""
    monkeypatch.setenv("OPENAI_BASE_URL", f"{llama_server.listening_address}/v1")
    monkeypatch.delenv("OPENAI_API_KEY", raising=False)
    for variable in ("HTTP_PROXY", "HTTPS_PROXY", "ALL_PROXY", "http_proxy", "https_proxy"):
        monkeypatch.setenv(variable, "http://127.0.0.1:9")
    opened = open_backend("openai:gemma")
    yield opened
    opened.close()


def test_llama_cpps_server_chooses_what_the_model_in_this_process_chooses(served, gemma):
    things = (" pan", " pen", " pencil", " pot", " potato")
    finds = [f" find a{thing}" for thing in things]
    for thing in things:
        prompt = Prompt(f"{EXAMPLES}\nHuman: Bring me the{thing}.\nRobot:")
        chosen = served.choose(prompt, finds)
        assert chosen.text == gemma.choose(prompt, finds).text
        assert chosen.prompt == prompt.text
        assert chosen.text in [one.text for one in chosen.alternatives]
        assert sum(one.probability for one in chosen.alternatives) <= 1.0001
        assert chosen.usage.prompt_tokens > 100
        assert chosen.usage.dollars == 0


def test_llama_cpps_server_generates_within_a_grammar_and_up_to_a_stop(served):
    answer = served.generate(Prompt("Is snow white? Answer:"), grammar='root ::= " yes" | " no"')
    assert answer.text in (" yes", " no")
    counted = served.generate(Prompt("1, 2, 3, 4,"), max_tokens=20, stop=[" 7"])
    assert counted.text == " 5, 6,"


def test_llama_cpps_server_takes_chat_prompts_and_beginnings(served):
    prompt = Prompt("Which is an animal?", chat=True, begun="It is the")
    chosen = served.choose(prompt, [" cat", " chair"])
    assert chosen.text in (" cat", " chair")
    assert prompt.text in chosen.prompt
    assert chosen.prompt.endswith(prompt.begun)


def test_a_prompt_that_is_too_long_is_refused_with_the_reason(served):
    with pytest.raises(ReibenchError, match="exceeds the available context"):
        served.generate(Prompt("word " * 4000))
    assert served.generate(Prompt("1, 2, 3,"), max_tokens=3).text == " 4,"


def test_eight_threads_play_whole_episodes_with_one_backend(served, episodes):
    assert is_concurrent(served)
    spec = RunSpec(model=served.name, max_steps=2)
    chosen = sorted(episodes.values(), key=lambda one: one.id)[:8]

    def played(episode):
        world = worlds.create("embedded")
        rollout = Rollout(episode, world, max_steps=2)
        rollout.start()
        steps = list(play(spec, rollout, served))
        world.close()
        return [step.decision for step in steps], rollout

    with ThreadPoolExecutor(8) as pool:
        finished = list(pool.map(played, chosen))
    for decisions, rollout in finished:
        assert rollout.over
        assert all(one.skill in SKILLS for one in decisions)
        assert all(one.usage.prompt_tokens for one in decisions)
        # what it was asked is its own episode's
        said_last = rollout.episode.dialogue.instruction.text
        assert all(said_last in one.prompt for one in decisions)


TROUBLE = {
    "HTTP 429": error(429, headers={"Retry-After": "0.05"}),
    "HTTP 500": error(500),
    "HTTP 503": error(503),
    "half an answer": Reply(said("x").content, half=True),
    "an answer without choices": Reply({"choices": []}),
    "a body that is no answer": Reply("oops"),
    "a connection cut off": Reply(reset=True),
    "a stall": Reply(stall=True),
}


@pytest.mark.parametrize("trouble", TROUBLE.values(), ids=TROUBLE)
def test_trouble_that_passes_is_survived(trouble):
    with serving() as server:
        model = model_of(server, seconds=0.5 if trouble.stall else 20)
        model.choose(Prompt("Robot:"), OPTIONS)
        server.next = [trouble, trouble]
        server.asked.clear()
        assert model.choose(Prompt("Robot:"), OPTIONS).text == OPTIONS[0]
        assert len(server.asked) == 3


def test_trouble_while_finding_out_what_the_server_can_do_does_not_mislead():
    with serving() as server:
        server.next = [error(503), error(429), Reply(reset=True)]
        assert model_of(server).choose(Prompt("Robot:"), OPTIONS).text == OPTIONS[0]
        assert "response_format" in server.asked[-1][1]


def test_a_server_that_never_recovers_gives_one_clear_error_and_an_error_record(
    world, store, episode
):
    with serving(lambda path, body: error(500, "out of memory")) as server:
        model = model_of(server, tries=3)
        spec = RunSpec(model="openai:m")
        [record] = evaluate(spec, [episode], model, world, store)
    assert record.status == "error"
    assert "out of memory; asked 3 times, then given up" in record.error
    assert store.finished(spec)


def test_a_server_that_is_not_there_is_said_when_it_is_opened(monkeypatch):
    with serving() as server:
        address = server.address
    monkeypatch.setenv("OPENAI_BASE_URL", address)
    with pytest.raises(ModelUnavailable, match=r"http://127\.0\.0\.1:\d+ cannot be reached"):
        open_backend("openai:m")


def test_an_answer_that_breaks_the_schema_is_asked_for_again():
    with serving() as server:
        model = model_of(server)
        model.choose(Prompt("Robot:"), OPTIONS)
        server.next = [said('{"choice": "fly away"}'), said("{"), said('{"choice": "done"}')]
        selection = model.choose(Prompt("Robot:"), OPTIONS)
        assert selection.text == " done"
        # every answer is paid for, and the model is told what was wrong
        assert selection.usage.prompt_tokens == 300
        turns = server.asked[-1][1]["messages"]
        assert [turn["role"] for turn in turns] == ["user", "assistant", "user"]
        assert "exactly one of these: find a mug; find a pan; done" in turns[-1]["content"]
        assert "exactly one of these" in selection.prompt


def test_an_answer_that_can_only_mean_one_option_is_taken_for_it_in_the_end():
    with serving() as server:
        model = model_of(server)
        model.choose(Prompt("Robot:"), OPTIONS)
        server.next = [said("I would find a pan, I think.")] * 3
        assert model.choose(Prompt("Robot:"), OPTIONS).text == " find a pan"


def test_an_answer_that_means_nothing_is_an_error_that_quotes_it():
    with serving() as server:
        model = model_of(server)
        model.choose(Prompt("Robot:"), OPTIONS)
        server.next = [said("I cannot help with that.")] * 3
        with pytest.raises(ReibenchError, match=r"asked 3 times .* 'I cannot help with that\.'"):
            model.choose(Prompt("Robot:"), OPTIONS)


def test_what_the_server_can_do_is_found_out_once_however_many_threads_ask():
    with serving() as server:
        model = model_of(server)
        with ThreadPoolExecutor(8) as pool:
            list(pool.map(lambda _: model.choose(Prompt("Robot:"), OPTIONS), range(24)))
        found_out = [body for _, body in server.asked if "colour" in str(body)]
        assert len(found_out) == 5  # one for text, four for chat: OpenAI's way is the fourth
        assert len(server.asked) == 24 + 5


def vllm(field):
    """Answer like vLLM, which keeps to its own field and ignores what it does not know."""

    def proper(path, body):
        held = body.get(field)
        options = held["choice"] if isinstance(held, dict) else held
        text = options[0] if options else "Blue, I think"
        if path == "/v1/completions":
            return Reply({"choices": [{"text": text}], "usage": None})
        return said(text)

    return proper


@pytest.mark.parametrize("field", ["structured_outputs", "guided_choice"])
def test_vllms_own_fields_are_used_where_the_server_keeps_to_them(field):
    with serving(vllm(field)) as server:
        assert model_of(server).choose(Prompt("Robot:"), OPTIONS).text == OPTIONS[0]
        path, body = server.asked[-1]
        assert (path, body["prompt"]) == ("/v1/completions", "Robot:")
        assert field in body


def test_a_server_that_holds_to_nothing_is_told_the_options():
    with serving(lambda path, body: said("Find a pan!")) as server:
        model = model_of(server)
        selection = model.choose(Prompt("Which?", chat=True), OPTIONS)
        assert selection.text == " find a pan"
        assert "exactly one of these: find a mug; find a pan; done" in selection.prompt


def test_fields_a_model_does_not_know_are_left_out_from_then_on():
    def reasoning(path, body):
        for name in ("temperature", "max_tokens", "logprobs"):
            if name in body:
                return error(400, f"Unsupported parameter: '{name}'", param=name)
        return obliging(path, body)

    with serving(reasoning) as server:
        model = model_of(server)
        model.choose(Prompt("Robot:"), OPTIONS)
        server.asked.clear()
        model.choose(Prompt("Robot:"), OPTIONS)
        [(_, body)] = server.asked
        assert not {"temperature", "max_tokens", "logprobs", "top_logprobs"} & body.keys()
        assert body["max_completion_tokens"] > 1000


def test_a_model_without_a_chat_template_is_asked_for_text():
    def base(path, body):
        if path != "/v1/completions":
            return error(400, "no chat template")
        return Reply({"choices": [{"text": " find a pan"}]})

    with serving(base) as server:
        generation = model_of(server).generate(Prompt("Robot:", chat=True), max_tokens=5)
        assert (generation.text, generation.prompt) == (" find a pan", "Robot:")


def test_the_endpoint_can_be_named(monkeypatch):
    with serving(vllm("guided_choice")) as server:
        monkeypatch.setenv("OPENAI_BASE_URL", server.address)
        model = open_backend("openai:m?endpoint=chat")
        assert model.name == "openai:m?endpoint=chat"
        model.choose(Prompt("Robot:"), OPTIONS)
        assert {path for path, _ in server.asked} == {"/v1/chat/completions"}


@pytest.mark.parametrize(
    ("source", "hint"),
    [("m?endpoint=chats", "Did you mean 'chat'"), ("m?key=1", "openai:NAME"), ("?", "openai:NAME")],
)
def test_options_that_do_not_exist_are_refused(source, hint):
    with pytest.raises(UnknownName, match=hint):
        open_backend(f"openai:{source}")


def test_a_limit_is_waited_for_by_every_thread(monkeypatch):
    slept, lock = [], Lock()

    def sleep(seconds):
        with lock:
            slept.append(seconds)

    with serving() as server:
        model = model_of(server, tries=50)
        model.choose(Prompt("Robot:"), OPTIONS)
        server.next = [error(429, headers={"Retry-After": "0.3"})]
        server.asked.clear()
        monkeypatch.setattr("reibench.backends.patience.sleep", sleep)
        with ThreadPoolExecutor(4) as pool:
            texts = list(pool.map(lambda _: model.choose(Prompt("?"), OPTIONS).text, range(8)))
        assert texts == [OPTIONS[0]] * 8
        assert len(server.asked) == 9
        assert max(slept) > 0.1


def test_a_used_up_quota_is_not_asked_again():
    with serving() as server:
        model = model_of(server)
        model.choose(Prompt("Robot:"), OPTIONS)
        server.next = [error(429, "You exceeded your quota", code="insufficient_quota")]
        server.asked.clear()
        with pytest.raises(ReibenchError, match="exceeded your quota"):
            model.choose(Prompt("Robot:"), OPTIONS)
        assert len(server.asked) == 1


def test_a_key_is_sent_and_shown_nowhere(world, store, episode, caplog):
    caplog.set_level(logging.DEBUG)
    quoting = error(401, f"Incorrect API key provided: {KEY}, or sk-very**7890")
    with serving(lambda path, body: quoting) as server:
        model = model_of(server)
        [record] = evaluate(RunSpec(model="openai:m"), [episode], model, world, store)
        assert server.keys == {f"Bearer {KEY}"}
    assert "check OPENAI_API_KEY" in record.error
    kept = store.path.read_bytes() + b"".join(
        path.read_bytes() for path in store.path.parent.glob("*.db-*")
    )
    shown = record.error + repr(model) + repr(vars(model)) + repr(record) + caplog.text
    assert KEY not in shown
    assert "sk-very" not in shown
    assert b"sk-very" not in kept


def test_a_server_elsewhere_needs_a_key_from_the_environment(monkeypatch):
    monkeypatch.delenv("OPENAI_API_KEY", raising=False)
    monkeypatch.delenv("OPENAI_BASE_URL", raising=False)
    with pytest.raises(ModelUnavailable, match="OPENAI_API_KEY is not set"):
        open_backend("openai:gpt-4o-mini")


def test_a_closed_model_says_so():
    with serving() as server:
        model = model_of(server)
        model.close()
        with pytest.raises(ModelUnavailable, match="has been closed"):
            model.choose(Prompt("Robot:"), OPTIONS)


def test_a_choice_goes_to_the_endpoint_that_can_be_held_to_it():
    """Ollama ignores fields it does not know and keeps to schemas in chat only."""

    def ollama(path, body):
        if path == "/v1/completions":
            return Reply({"choices": [{"text": " find a spaceship"}]})
        return obliging(path, {"response_format": body["response_format"]} if holds(body) else {})

    def holds(body):
        return "response_format" in body

    with serving(ollama) as server:
        model = model_of(server)
        assert model.choose(Prompt("Robot:"), OPTIONS).text == OPTIONS[0]
        assert server.asked[-1][0] == "/v1/chat/completions"
        assert model.generate(Prompt("Robot:")).text == " find a spaceship"


def test_a_beginning_the_model_repeats_in_chat_is_left_out_of_what_goes_on():
    with serving(lambda path, body: said("It is the cat. Yes.")) as server:
        model = model_of(server)
        prompt = Prompt("Which?", chat=True, begun="It is the")
        assert model.generate(prompt, stop=["."]).text == " cat"


def test_what_is_paid_for_is_what_all_asked_answers_cost_by_the_price_list():
    with serving() as server:
        connection = Connection(server.address, KEY, patience=Patience(first=0.01))
        paid = RemoteModel("gpt-4o-mini", connection, price=price_of("gpt-4o-mini"))
        free = model_of(server, "gpt-4o-mini")
        paid.choose(Prompt("Robot:"), OPTIONS)
        server.next = [said("?"), said('{"choice": "done"}')]
        usage = paid.choose(Prompt("Robot:"), OPTIONS).usage
        assert usage.dollars == pytest.approx(2 * (100 * 0.15 + 10 * 0.60) / 1e6)
        assert free.choose(Prompt("Robot:"), OPTIONS).usage.dollars == 0
