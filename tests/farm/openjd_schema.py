"""The rules of Open Job Description for job templates, version 2023-09, as far as a template of ours may touch them.

Written down from the page "Template Schemas" (2023-09) of github.com/OpenJobDescription/openjd-specifications; the numbers of its
sections stand beside the rules. `faults(template)` returns what breaks one.
"""
import re
import unicodedata

IDENTIFIER = r"[A-Za-z_][A-Za-z0-9_]*"
EXPRESSION = re.compile(r"\{\{(.*?)\}\}")


def faults(template):
    found = []

    def want(true, text):
        if not true:
            found.append(text)

    def keys(where, value, needed, optional=()):
        want(isinstance(value, dict), f"{where} is no object")
        if not isinstance(value, dict):
            return {}
        for key in needed:
            want(key in value, f"{where} lacks {key}")
        for key in value:
            want(key in needed or key in optional, f"{where} may not have {key}")
        return value

    def text(where, value, most=None, least=1):
        want(isinstance(value, str), f"{where} is no string")
        if not isinstance(value, str):
            return
        want(len(value) >= least and (most is None or len(value) <= most), f"{where} has {len(value)} characters")
        want(not any(unicodedata.category(c) == "Cc" for c in value), f"{where} has control characters")

    def formatted(where, value, names, most=None):
        text(where, value, most)
        inside = EXPRESSION.findall(str(value))
        for name in inside:
            want(name.strip() in names, f"{where}: {name} has no value here")
        want("{{" not in EXPRESSION.sub("", str(value)), f"{where} opens an expression without an end")

    def action(where, value, names):  # 5
        keys(where, value, ["command"], ["args", "timeout", "cancelation"])
        formatted(where + ".command", value.get("command"), names)  # 5.1
        for i, arg in enumerate(value.get("args", [])):
            if arg != "":
                formatted(f"{where}.args[{i}]", arg, names)  # 5.2
        cancel = value.get("cancelation")
        if cancel is not None:  # 5.3
            mode = cancel.get("mode")
            want(mode in ("TERMINATE", "NOTIFY_THEN_TERMINATE"), f"{where}: no such way of cancelation: {mode}")
            keys(where + ".cancelation", cancel, ["mode"], ["notifyPeriodInSeconds"] if mode != "TERMINATE" else [])
            period = cancel.get("notifyPeriodInSeconds", 1)
            want(isinstance(period, int) and 1 <= period <= 600, f"{where}: a period of {period} s")

    root = keys("template", template, ["specificationVersion", "name", "steps"],  # 1.1
                ["$schema", "extensions", "description", "parameterDefinitions", "jobEnvironments"])
    want(root.get("specificationVersion") == "jobtemplate-2023-09", "another version of the specification")
    names = set()
    parameters = root.get("parameterDefinitions")
    if parameters is not None:
        want(1 <= len(parameters) <= 50, "from 1 to 50 parameters")
        for p in parameters:  # 2.2
            keys("parameter", p, ["name", "type"], ["description", "default", "allowedValues", "minLength", "maxLength", "objectType",
                                                    "dataFlow", "userInterface"])
            want(re.fullmatch(IDENTIFIER, p.get("name", "")) and len(p["name"]) <= 64, "a parameter's name is no identifier")  # 7.1
            want(p.get("type") in ("STRING", "PATH", "INT", "FLOAT"), f"no such type: {p.get('type')}")
            want(len(p.get("default", "")) <= 1024, "a default of more than 1024 characters")  # 2.5
            want(p.get("objectType", "DIRECTORY") in ("FILE", "DIRECTORY"), "objectType")
            want(p.get("dataFlow", "NONE") in ("NONE", "IN", "OUT", "INOUT"), "dataFlow")
            want(len(p.get("description", " ")) in range(1, 2049), "description")  # 7.2
            names |= {f"Param.{p['name']}", f"RawParam.{p['name']}"}
    formatted("name", root.get("name"), names, 128)  # 1.1.1
    steps = root.get("steps", [])
    want(len(steps) >= 1, "no steps")
    step_names = [s.get("name") for s in steps]
    want(len(set(step_names)) == len(step_names), "two steps of one name")
    for step in steps:  # 3
        where = f"step {step.get('name')}"
        keys(where, step, ["name", "script"], ["description", "dependencies", "stepEnvironments", "hostRequirements", "parameterSpace"])
        text(where + ".name", step.get("name"), 64)  # 3.1
        if "dependencies" in step:  # 3.2
            want(len(step["dependencies"]) >= 1, f"{where}: an empty list of dependencies")
            for one in step["dependencies"]:
                keys(where + ".dependency", one, ["dependsOn"])
                want(one.get("dependsOn") in step_names and one.get("dependsOn") != step["name"], f"{where} waits for no step")
        if "hostRequirements" in step:  # 3.3
            needs = keys(where + ".hostRequirements", step["hostRequirements"], [], ["amounts", "attributes"])
            want(1 <= len(needs.get("amounts", [])) + len(needs.get("attributes", [])) <= 50, f"{where}: how many requirements")
            for amount in needs.get("amounts", []):  # 3.3.1
                keys(where + ".amount", amount, ["name"], ["min", "max"])
                want(re.fullmatch(rf"({IDENTIFIER}:)?amount\.{IDENTIFIER}(\.{IDENTIFIER})*", amount.get("name", "")), f"{where}: amount")
                want("min" in amount or "max" in amount, f"{where}: an amount without a limit")
                least = 1 if amount.get("name") == "amount.worker.vcpu" else 0
                want(isinstance(amount.get("min", 1), (int, float)) and amount.get("min", 1) >= least, f"{where}: min")
        inner = names | {"Session.WorkingDirectory"}
        if "parameterSpace" in step:  # 3.4
            space = keys(where + ".parameterSpace", step["parameterSpace"], ["taskParameterDefinitions"], ["combination"])
            want(1 <= len(space["taskParameterDefinitions"]) <= 16, f"{where}: from 1 to 16 parameters of tasks")
            for p in space["taskParameterDefinitions"]:
                keys(where + ".task parameter", p, ["name", "type", "range"])
                want(p.get("type") in ("INT", "FLOAT", "STRING", "PATH"), f"{where}: type of a task's parameter")
                if isinstance(p.get("range"), str):  # 3.4.1.1.1
                    want(re.fullmatch(r"\s*-?\d+\s*(-\s*-?\d+\s*(:-?\d+)?)?(,\s*-?\d+\s*(-\s*-?\d+\s*(:-?\d+)?)?)*", p["range"]),
                         f"{where}: a range of {p['range']}")
                else:
                    want(1 <= len(p.get("range", [])) <= 1024, f"{where}: from 1 to 1024 values")
                inner |= {f"Task.Param.{p['name']}", f"Task.RawParam.{p['name']}"}
        script = keys(where + ".script", step.get("script"), ["actions"], ["embeddedFiles"])  # 3.5
        action(where + ".onRun", keys(where + ".actions", script.get("actions"), ["onRun"]).get("onRun", {}), inner)
    return found
