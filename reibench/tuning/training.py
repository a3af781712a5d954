"""Teaching an adapter: low-rank changes of every linear layer (LoRA), by peft and torch."""

import json
import logging
from collections.abc import Callable, Sequence
from dataclasses import asdict
from pathlib import Path
from random import Random
from time import perf_counter
from typing import Any

from reibench.tuning.coding import Coded, batches
from reibench.tuning.teaching import Recipe

log = logging.getLogger(__name__)

Progress = Callable[[int, int, float, float], None]
"""Told the step, the number of steps, the mean loss of late and the seconds left."""


class Trainer:
    """One adapter being taught; what it knows is kept in `folder` and gone on from."""

    def __init__(
        self,
        model: Any,
        coded: Sequence[Coded],
        allowed: Sequence[int],
        recipe: Recipe,
        folder: Path,
    ) -> None:
        """Prepare.

        Args:
            model: a causal model of transformers, in float32.
            coded: what is taught.
            allowed: the tokens it chooses among; the softmax is over these alone.
            recipe: how.
            folder: where it is kept.
        """
        import torch
        from peft import LoraConfig, get_peft_model

        torch.manual_seed(recipe.seed)
        config = LoraConfig(
            r=recipe.rank,
            lora_alpha=recipe.alpha,
            target_modules="all-linear",
            task_type="CAUSAL_LM",
        )
        self.model = get_peft_model(model, config)
        self.model.train()
        self._coded, self._recipe, self._folder = coded, recipe, folder
        self._place_of = {token: place for place, token in enumerate(allowed)}
        self._output = model.get_output_embeddings().weight[list(allowed)].detach()
        self._taught = [each for each in self.model.parameters() if each.requires_grad]
        self._optimizer = torch.optim.AdamW(self._taught, lr=recipe.rate, weight_decay=0.0)
        shuffled = list(range(len(coded)))
        Random(recipe.seed).shuffle(shuffled)
        self._batches = list(batches(coded, recipe.batch, shuffled))
        self.losses: list[float] = []

    @property
    def steps(self) -> int:
        """How many steps there are in all."""
        return len(self._batches)

    def run(self, progress: Progress, *, keep_every: int = 50) -> None:
        """Teach what is left to teach."""
        self._resume()
        begun, started = len(self.losses), perf_counter()
        for number in range(begun, self.steps):
            self.losses.append(self._step(number))
            done = number + 1
            pace = (perf_counter() - started) / (done - begun)
            late = self.losses[-20:]
            progress(done, self.steps, sum(late) / len(late), pace * (self.steps - done))
            if done % keep_every == 0 or done == self.steps:
                self._keep()

    def _step(self, number: int) -> float:
        import torch

        rate = self._recipe.rate * min(
            (number + 1) / self._recipe.warm_up, (self.steps - number) / self.steps
        )
        for group in self._optimizer.param_groups:
            group["lr"] = rate
        loss = self.loss(self._batches[number])
        loss.backward()
        torch.nn.utils.clip_grad_norm_(self._taught, self._recipe.clip)
        self._optimizer.step()
        self._optimizer.zero_grad(set_to_none=True)
        return float(loss)

    def loss(self, batch: Sequence[Coded]) -> Any:
        """Return the mean cross-entropy of what is taught in a batch, as a tensor."""
        import torch

        longest = max(len(one.tokens) for one in batch)
        tokens = torch.zeros(len(batch), longest, dtype=torch.long)
        mask = torch.zeros_like(tokens)
        rows, places, wanted = list[int](), list[int](), list[int]()
        for row, one in enumerate(batch):
            tokens[row, : len(one.tokens)] = torch.tensor(one.tokens)
            mask[row, : len(one.tokens)] = 1
            for place, token in one.taught:
                rows.append(row)
                places.append(place)
                wanted.append(self._place_of[token])
        inner = self.model.base_model.model.model
        states = inner(input_ids=tokens, attention_mask=mask).last_hidden_state
        scores = states[rows, places] @ self._output.T
        return torch.nn.functional.cross_entropy(scores, torch.tensor(wanted))

    def close(self) -> None:
        """Give the model back as it was."""
        self.model.unload()

    def weights(self) -> dict[str, Any]:
        """Return what was learnt, by the names of transformers."""
        return {
            name.removeprefix("base_model.model.").replace(".default", ""): value.detach()
            for name, value in self.model.named_parameters()
            if value.requires_grad
        }

    def _keep(self) -> None:
        import torch

        self._folder.mkdir(parents=True, exist_ok=True)
        state = {
            "recipe": json.dumps(asdict(self._recipe)),
            "losses": self.losses,
            "weights": [each.detach() for each in self._taught],
            "optimizer": self._optimizer.state_dict(),
        }
        part = self._folder / "state.part"
        torch.save(state, part)
        part.replace(self._folder / "state.pt")

    def _resume(self) -> None:
        import torch

        kept = self._folder / "state.pt"
        if not kept.is_file():
            return
        state = torch.load(kept, weights_only=True)
        if state["recipe"] != json.dumps(asdict(self._recipe)):
            log.warning("%s was made by another recipe; it begins anew", kept)
            return
        with torch.no_grad():
            for each, value in zip(self._taught, state["weights"], strict=True):
                each.copy_(value)
        self._optimizer.load_state_dict(state["optimizer"])
        self.losses = list(state["losses"])
