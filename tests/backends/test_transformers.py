"""Causal models through transformers: tiny ones of several families."""

import os
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from threading import Thread

import pytest

from reibench.backends import Prompt
from reibench.backends.opening import open_backend
from reibench.errors import ModelUnavailable, ReibenchError, UnknownName
from reibench.skill import DONE, SKILLS
from tests.backends.tiny import tiny

OPTIONS = [*(f" {skill}" for skill in SKILLS), f" {DONE}"]
ROOT = "Robot: find a mug, pick up the mug,"


@pytest.fixture(scope="module")
def checkpoint(tmp_path_factory):
    return tiny(tmp_path_factory.mktemp("llama"))


@pytest.fixture(scope="module")
def model(checkpoint):
    opened = open_backend(f"hf:{checkpoint}")
    yield opened
    opened.close()


def test_a_model_answers_the_same_whatever_it_was_asked_before(checkpoint):
    prompts = [
        Prompt(f"{ROOT} find a {thing}, {'find a sink, ' * number}find")
        for number, thing in enumerate(["pan", "pot", "potato", "pan"])
    ]
    used = open_backend(f"hf:{checkpoint}?slots=2")
    for prompt in prompts:
        fresh = open_backend(f"hf:{checkpoint}")
        assert used.generate(prompt, max_tokens=6).text == fresh.generate(prompt, max_tokens=6).text
        assert used.choose(prompt, OPTIONS).text == fresh.choose(prompt, OPTIONS).text


def test_only_what_is_new_in_a_prompt_is_evaluated(model):
    model.choose(Prompt(ROOT), OPTIONS)
    again = model.choose(Prompt(f"{ROOT} find a sink,"), OPTIONS).usage
    assert again.prompt_tokens - again.cached_tokens < 20
    assert again.cached_tokens > 10


def test_two_kinds_of_prompts_asked_in_turn_stay_evaluated_side_by_side(model):
    first, second = "Human: bring the mug. " * 4, "A list of things: pan, pot, " * 4
    for _ in range(2):
        usages = [model.choose(Prompt(text), OPTIONS).usage for text in (first, second)]
    assert all(usage.cached_tokens > 0.6 * usage.prompt_tokens for usage in usages)


def test_tokens_without_a_choice_are_taken_in_one_pass(model):
    passes = []
    hook = model._running().model.register_forward_hook(lambda *_: passes.append(1))
    model.choose(
        Prompt(ROOT), [" open the fridge door wide now", " open the fridge door wide then"]
    )
    hook.remove()
    assert len(passes) == 1 or len(passes) == 2  # at the parting, and within its runner-up


def test_a_prompt_is_sent_in_the_chat_template_if_asked_and_there_is_one(tmp_path, model):
    asked = Prompt("Bring a mug.", chat=True, begun=" find")
    chat = open_backend(f"hf:{tiny(tmp_path, chat=True)}")
    assert chat.generate(asked, max_tokens=2).prompt == "[INST] Bring a mug. [/INST] Answer: find"
    assert chat.choose(Prompt("Robot:"), OPTIONS).prompt == "Robot:"
    assert model.generate(asked, max_tokens=2).prompt == "Bring a mug. find"


def test_usage_counts_what_was_sent_and_made(model):
    usage = model.generate(Prompt(ROOT), max_tokens=5).usage
    assert 0 < usage.completion_tokens <= 5
    assert 0 <= usage.cached_tokens <= usage.prompt_tokens
    assert usage.seconds > 0
    assert usage.dollars == 0


def test_threads_may_ask_at_once(model):
    prompts = [Prompt(f"{ROOT} find a {thing},") for thing in ("pan", "pot", "potato", "mug")]
    alone = [model.choose(prompt, OPTIONS).text for prompt in prompts]
    with ThreadPoolExecutor(4) as pool:
        together = list(pool.map(lambda prompt: model.choose(prompt, OPTIONS).text, prompts))
    assert together == alone


def test_a_closed_model_says_so(checkpoint):
    opened = open_backend(f"hf:{checkpoint}")
    opened.close()
    with pytest.raises(ModelUnavailable, match="has been closed"):
        opened.choose(Prompt(ROOT), OPTIONS)


def test_a_prompt_that_is_too_long_is_refused_with_the_reason(tmp_path):
    short = open_backend(f"hf:{tiny(tmp_path, max_position_embeddings=16)}")
    with pytest.raises(ReibenchError, match="exceeds the available context of this model"):
        short.generate(Prompt("find a mug, " * 20))


def test_a_grammar_that_is_none_is_refused_with_the_reason(model):
    with pytest.raises(ReibenchError, match="is no grammar"):
        model.generate(Prompt(ROOT), grammar="root ::= (")


def test_number_formats_and_the_device_can_be_chosen(checkpoint):
    short = open_backend(f"hf:{checkpoint}?dtype=bfloat16&device=cpu")
    assert short.choose(Prompt(ROOT), OPTIONS).text in OPTIONS
    assert short.name == f"hf:{checkpoint}?dtype=bfloat16&device=cpu"


@pytest.mark.parametrize(
    ("options", "hint"),
    [
        ("dtyp=bfloat16", "Did you mean 'dtype'"),
        ("dtype=bf16", "Did you mean 'bfloat16'"),
        ("quantization=4bits", "Did you mean '4bit'"),
        ("slots=0", "is 1 or more"),
        ("bfloat16", "should read like"),
        ("device=", "has no value"),
    ],
)
def test_a_wrong_option_is_answered_with_a_right_one(options, hint):
    with pytest.raises(ReibenchError, match=hint):
        open_backend(f"hf:org/name?{options}")


@pytest.mark.parametrize(
    ("name", "hint"),
    [
        ("absent.gguf", r"no model file absent\.gguf"),
        ("gemma-3-270m?quantization=4bit", "quantized already"),
        ("{checkpoint}?device=cuda:77", "no device 'cuda:77'"),
        ("{checkpoint}/absent", "neither a folder here nor a repository"),
    ],
)
def test_what_cannot_be_opened_is_named_with_the_reason(checkpoint, name, hint):
    with pytest.raises(ModelUnavailable, match=hint):
        open_backend("hf:" + name.format(checkpoint=checkpoint))


def test_a_name_that_is_neither_a_folder_nor_a_repository_is_answered_with_a_right_one():
    with pytest.raises(UnknownName, match="Did you mean 'gemma-3-270m'"):
        open_backend("hf:gemma-3-27b")


def test_a_damaged_checkpoint_says_what_is_wrong(tmp_path):
    folder = tiny(tmp_path)
    weights = folder / "model.safetensors"
    weights.write_bytes(weights.read_bytes()[:1000])
    with pytest.raises(ModelUnavailable, match="cannot be loaded as a causal language model"):
        open_backend(f"hf:{folder}")


def test_a_model_that_is_not_causal_is_refused(tmp_path):
    from transformers import ViTConfig, ViTModel

    folder = tiny(tmp_path)
    (folder / "config.json").unlink()
    (folder / "model.safetensors").unlink()
    ViTModel(ViTConfig(hidden_size=8, num_hidden_layers=1, num_attention_heads=2)).save_pretrained(
        folder
    )
    with pytest.raises(ModelUnavailable, match="cannot be loaded as a causal language model"):
        open_backend(f"hf:{folder}")


@pytest.mark.parametrize("package", ["torch", "transformers", "llguidance"])
def test_a_missing_package_is_named_with_what_installs_it(monkeypatch, checkpoint, package):
    monkeypatch.setitem(sys.modules, package, None)
    with pytest.raises(ModelUnavailable, match=rf"\({package}\).*requirements-hf\.txt"):
        open_backend(f"hf:{checkpoint}")


def test_quantizing_without_its_package_names_it(monkeypatch, checkpoint):
    monkeypatch.setitem(sys.modules, "bitsandbytes", None)
    with pytest.raises(ModelUnavailable, match="pip install bitsandbytes"):
        open_backend(f"hf:{checkpoint}?quantization=8bit")


class Hub(BaseHTTPRequestHandler):
    """A hub where everything is gated, or absent."""

    def do_HEAD(self):
        kind = "GatedRepo" if "/gated/" in self.path else "RepoNotFound"
        self.send_response(403 if kind == "GatedRepo" else 404)
        self.send_header("X-Error-Code", kind)
        self.send_header("Content-Length", "0")
        self.end_headers()

    do_GET = do_HEAD

    def log_message(self, *args):
        pass


ASKED = """
import sys
from reibench.backends.opening import open_backend
from reibench.errors import ModelUnavailable
for name in sys.argv[1:]:
    try:
        open_backend(name)
    except ModelUnavailable as error:
        print(error)
"""


def tried(address: str, cache: str, *names: str) -> list[str]:
    """Return why each cannot be had; the hub's address is read once, so in a fresh process."""
    settings = {"HF_ENDPOINT": address, "HF_HOME": cache, "NO_PROXY": "127.0.0.1"}
    run = subprocess.run(
        [sys.executable, "-c", ASKED, *names],
        env={**os.environ, **settings},
        cwd=Path(__file__).parents[2],
        capture_output=True,
        text=True,
        check=True,
    )
    return run.stdout.splitlines()


def test_why_the_hub_gives_nothing_is_said_in_a_sentence(tmp_path):
    server = ThreadingHTTPServer(("127.0.0.1", 0), Hub)
    Thread(target=server.serve_forever, daemon=True).start()
    address = f"http://127.0.0.1:{server.server_port}"
    gated, absent = tried(address, str(tmp_path), "hf:gated/model", "hf:absent/model")
    server.shutdown()
    assert "accepted its licence" in gated
    assert "HF_TOKEN" in gated
    assert "neither a folder here nor a repository on the hub" in absent


def test_a_hub_that_cannot_be_reached_is_said_in_a_sentence(tmp_path):
    [why] = tried("http://127.0.0.1:9", str(tmp_path), "hf:some/model")
    assert "the hub cannot be reached" in why
