"""The `ai2thor` world: the skill layer over AI2-THOR's own client, driving Unity.

`ai2thor:stand-in`, `ai2thor:PATH` and `ai2thor:BUILD` say which Unity; see `builds`.
"""

from dataclasses import replace

from reibench.episode import Task
from reibench.errors import WorldUnavailable
from reibench.skill import Skill
from reibench.worlds import Announce, Event, World, silently, worlds
from reibench.worlds.ai2thor import builds
from reibench.worlds.ai2thor.settings import UnitySettings
from reibench.worlds.ai2thor.simulator import UnitySimulator
from reibench.worlds.rules import STRICT, Rules
from reibench.worlds.thor import ThorWorld


class UnityWorld(ThorWorld):
    """Household skills in Unity, with what its cameras see."""

    def __init__(self, simulator: UnitySimulator, rules: Rules) -> None:
        super().__init__(simulator, rules)
        self._cameras = simulator

    def reset(self, task: Task) -> Event:
        """Set up the task's room; raises WorldBroken when Unity does not start."""
        return self._seen(super().reset(task))

    def step(self, skill: Skill) -> Event:
        """Carry out `skill`; raises WorldBroken when Unity does not answer."""
        return self._seen(super().step(skill))

    def _seen(self, event: Event) -> Event:
        return replace(event, frames=self._cameras.frames())


class UnityWorlds:
    """Makes worlds over one Unity or another."""

    def __call__(
        self,
        rules: Rules = STRICT,
        *,
        variant: str = "",
        frames: bool = False,
        announce: Announce = silently,
    ) -> World:
        """Make a world; a build that has to be downloaded is announced and fetched first.

        Raises:
            WorldUnavailable: when that Unity cannot be had here.
        """
        variant, settings = builds.resolve(variant), UnitySettings.from_environment()
        if download := builds.check(variant, settings):
            announce(str(download))
            fetch(variant, settings, download)
        return UnityWorld(UnitySimulator(variant, settings, frames=frames), rules)

    def resolve(self, variant: str) -> str:
        """Return the variant that is meant, e.g. by none."""
        return builds.resolve(variant)

    def check(self, variant: str) -> None:
        """Raise WorldUnavailable when that Unity cannot be had here; downloads nothing."""
        builds.check(builds.resolve(variant), UnitySettings.from_environment())


def fetch(variant: str, settings: UnitySettings, download: builds.Download) -> None:
    """Let the client download a published build; raises WorldUnavailable."""
    from reibench.worlds.ai2thor.client import Client

    try:
        Client(variant, settings).download()
    except Exception as problem:  # The client raises bare ones.
        raise WorldUnavailable(
            f"Downloading AI2-THOR's build from {download.url} failed: {problem}."
            f" {builds.OTHERWISE}"
        ) from problem


worlds.register("ai2thor")(UnityWorlds())
