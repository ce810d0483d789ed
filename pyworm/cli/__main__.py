"""The program `pyworm`, also as `python -m pyworm.cli`: ready for signals before anything that takes time."""

import sys

from pyworm.cli.stopping import (
    end_at_once,
    end_if_stopped,
    end_in_order,
    exit_code,
    report_stopped,
)


def main() -> int:
    """Run the command line; returns the exit code (`pyworm.cli.main`)."""
    end_at_once()
    from pyworm.cli import main as cli  # takes a second
    from pyworm.io.on_demand import forbid

    # installed for clusters, xarray would load it to tell that no array is of it
    forbid("dask")

    try:
        end_in_order()
        code = cli.main()
    except KeyboardInterrupt as stop:  # before the command has begun, or after its end
        report_stopped()
        code = exit_code(stop)
    finally:
        end_at_once()
    end_if_stopped(code)
    return code


if __name__ == "__main__":
    sys.exit(main())
