"""Elastohydrodynamic lubrication of worm gears: films between teeth, rollers and balls.

A contact in five statements, numbers in SI:

    import pyworm
    steel = pyworm.Body.from_name("16MnCr5")
    oil = pyworm.named_oil("PAO VG 220").oil(333.15)
    motions = pyworm.RigidMotion(1.1, 0), pyworm.RigidMotion(0.9, 0)
    scene = pyworm.Scene(gap=pyworm.Paraboloid(0.01, 0.01), load=50, motions=motions,
                         bodies=(steel, steel), oil=oil)
    solution = pyworm.solve(scene, accuracy=0.02)

A contact
    Scene           a point contact at one instant
    LineScene       a line contact at one instant
    Paraboloid      gap of a point contact by its radii
    Parabola        gap of a line contact by its radius
    SampledGap      gap by an array of heights
    read_gap        a gap from a file
    RigidMotion     translation and spin of a surface
    with_slide_roll_ratio   a scene at another slide-roll ratio

Solids and oils
    Body            elastic and thermal constants of a solid, `Body.from_name` those of a material
    Coating         an elastic layer on it
    FatigueStrength what its material endures, over depth
    Roughness       height, slope, lay and asperities of a surface
    Oil             laws of viscosity, density, flow and heat
    Barus, Roelands     viscosity against pressure
    Density         density against pressure
    FlowLaw         how an oil shears under stress
    OilHeat         how an oil takes heat
    OilLayer        the oil that arrives, over the place across the track
    TabulatedViscosity, TabulatedDensity    a function or measurements over pressure and temperature
    Branch          one branch of a Carreau-Yasuda law
    named_liquid    a liquid of the literature, with its laws over pressure and temperature
    NamedOil        an oil over temperature, by its data sheet or measurements too
    named_oil       an oil of the list of oils
    read_oil        an oil from a file

Gear sets
    WormDrive, GearPair, RollerWorm     a gear set from its drawing and operation
    gear_set        a gear set of any kind, those of other packages too
    load            a case from its file or a dictionary, checked
    Case            what these give: it makes scenes
    check           its geometry, contacts, plans and expected time
    CheckedCase, PlannedContact     what `check` gives
    run             its solutions, mesh cycle, losses and efficiency, as a Result
    rate            its safeties and other ratings
    CaseRatings     what `rate` gives
    setup, shim     set-up of the hob and shim of the wheel for a contact pattern
    CaseSetup       what `setup` gives
    calibrate       values of a case, such as boundary friction, fitted to measurements
    Calibration     what `calibrate` gives
    design          the best gear set between bounds, under constraints
    BestDesign      what `design` gives
    wear            wear of the wheel over its service life
    CaseWear        what `wear` gives
    duty            temperatures, losses and damage of a gear unit over its duty
    CaseDuty        what `duty` gives

Solving
    plan            effects, grids and tolerance for an accuracy
    Plan            what `plan` gives
    solve           the film of a scene, to an accuracy or by its plan
    dry_contact     the pressure of a scene without oil
    passes          one contact after another over one track, by what each leaves
    rough_patch     rough surfaces resolved node by node, moving through a contact
    film            films of many contacts by a formula, without a solve
    film_of         those of a scene
    FormulaFilms    what they give
    compare_formulas    films of a scene by every formula, with ranges and deviations
    FormulaComparison, FormulaFilm      what `compare_formulas` gives
    sensitivities   how the figures of a scene follow each of its inputs
    Sensitivities, Sensitivity      what `sensitivities` gives
    traction_curve  friction over the slide-roll ratio
    sweep           many scenes to labelled arrays
    draw            values of a sweep that fill ranges evenly
    transient       films while load, speed or radii change

Results
    Solution        fields, figures, convergence and cost of one solve
    Figures         scalars of a solution
    Estimate        a figure with its error bar, to calculate with
    compare         two solutions side by side
    Comparison      what `compare` gives
    Result          solutions of a case, as files hold them
    open_result     a result from its file
    open_solution   a solution from its file
    SweepResult     labelled arrays and table of a sweep
    TransientResult     what `transient` gives
    open_sweep      a sweep from its file
    write_csv       fields as comma-separated values
    write_vtk       fields for ParaView

What goes wrong
    CaseError       invalid input, one sentence
    KernelError     the kernel gave up
    NoAdjointError  a film has no sensitivities
    UnusualWarning  a value that is mostly a slip

Beside
    formulas        closed forms: Hertz, films, regimes, ratings
    plots           pictures of solutions, curves and sweeps
"""

import os

import lazy_loader

# One thread a process unless asked otherwise, since batch work runs a process a core. This stands before
# NumPy and the kernel are loaded, which count their threads then.
os.environ.setdefault("OMP_NUM_THREADS", "1")
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

# At first use, so that a look at the version or a check of a case does not wait for, or need, the kernel.
__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
