import { useEffect, useState } from "react";
import type { AboutResponse } from "../../generated/responses";
import { platform } from "../../platform";
import { TextInput } from "../../shared/controls/inputs";
import { count } from "../../shared/figures/format";
import { Dialog } from "../../shared/layers/Dialog";
import { Scrolls } from "../../shared/lists/Scrolls";
import { told } from "../../state/asking/problems";
import { useUi } from "../../state/window/ui";
import "./about.css";

/** What this program is, and what it is made of. */
export function AboutDialog() {
  const shown = useUi((ui) => ui.dialog === "about");
  const showDialog = useUi((ui) => ui.showDialog);
  return shown ? <About onClose={() => showDialog(null)} /> : null;
}

function About({ onClose }: { readonly onClose: () => void }) {
  const [about, setAbout] = useState<AboutResponse | null>(null);
  useEffect(() => void told(platform.ask("about", {})).then(setAbout), []);
  return (
    <Dialog title="About WireBend-kit" onClose={onClose} wide>
      {about && (
        <>
          <p>{about.description}</p>
          <dl className="pairs">
            <Pair name="Version" value={about.version} />
            <Pair name="Licence" value={about.licence} />
            <Pair name="Driver interface" value={about.driver_interface} />
            <Pair name="Your own folder" value={about.own_folder ?? "None on this computer."} />
          </dl>
          {about.packages.length > 0 && <Packages packages={about.packages} />}
        </>
      )}
    </Dialog>
  );
}

function Pair({ name, value }: { readonly name: string; readonly value: string }) {
  return (
    <div>
      <dt>{name}</dt>
      <dd className="selectable">{value}</dd>
    </div>
  );
}

function Packages({ packages }: { readonly packages: AboutResponse["packages"] }) {
  const [filter, setFilter] = useState("");
  const wanted = filter.toLowerCase();
  const fit = packages.filter((one) => one.join(" ").toLowerCase().includes(wanted));
  return (
    <div className="stack">
      <h3 className="about-heading">Made with {count(packages.length, "package")} of others</h3>
      <TextInput
        aria-label="Filter packages"
        placeholder="Filter by name or licence"
        value={filter}
        onChange={(event) => setFilter(event.currentTarget.value)}
      />
      <Scrolls className="about-packages" label="Packages">
        <table>
          <thead>
            <tr>
              <th scope="col">Name</th>
              <th scope="col">Version</th>
              <th scope="col">Licence</th>
            </tr>
          </thead>
          <tbody>
            {fit.map(([name, version, licence]) => (
              <tr key={`${name} ${version}`} className="selectable">
                <th scope="row">{name}</th>
                <td>{version}</td>
                <td>{licence}</td>
              </tr>
            ))}
          </tbody>
        </table>
        {fit.length === 0 && <p className="muted">No package fits the filter.</p>}
      </Scrolls>
    </div>
  );
}
