#include "scene.h"

#include "scene_reader.h"
#include "scene_track.h"

#include <algorithm>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <utility>
#include <vector>

// A static library's resources are linked only when they are asked for; the macro must stand outside
// every namespace.
static void initSceneResources() { Q_INIT_RESOURCE(scenes); }

namespace lds::emulator {

using namespace Qt::StringLiterals;

namespace {

const QString exampleFolder = u":/lds/scenes"_s;
const QString exampleSuffix = u".json"_s;

/// A workpiece held under the beam by hand, in the light and noise of its scene.
class HeldStill final : public Scenery {
public:
    HeldStill(const Meeting& meeting, const Surroundings& surroundings)
        : m_meeting(meeting)
        , m_surroundings(surroundings)
    {}
    Sight at(qint64 timeNs) const override
    {
        return m_surroundings.showing(m_meeting, std::max<qint64>(0, timeNs));
    }

private:
    Meeting m_meeting;
    Surroundings m_surroundings;
};

} // namespace

struct Scene::Parts {
    QString name;
    QString description;
    QStringList workpieces;
    std::vector<Meeting> measuringPoints; ///< One a workpiece.
    Track track;
    Surroundings surroundings;
    QList<ScheduledFault> faults;
    QList<Interval> triggers;
};

Scene::Scene(std::shared_ptr<const Parts> parts)
    : m_parts(std::move(parts))
{}

Scene::~Scene() = default;

QString Scene::name() const { return m_parts->name; }

QString Scene::description() const { return m_parts->description; }

QStringList Scene::workpieces() const { return m_parts->workpieces; }

Sight Scene::at(qint64 timeNs) const
{
    const qint64 sinceStart = std::max<qint64>(0, timeNs);
    return m_parts->surroundings.showing(m_parts->track.at(sinceStart), sinceStart);
}

std::shared_ptr<const Scenery> Scene::holdingStill(const QString& workpiece) const
{
    const qsizetype index = m_parts->workpieces.indexOf(workpiece);
    if (index < 0)
        return nullptr;
    return std::make_shared<HeldStill>(m_parts->measuringPoints[std::size_t(index)], m_parts->surroundings);
}

const QList<ScheduledFault>& Scene::faults() const { return m_parts->faults; }

const QList<Interval>& Scene::triggers() const { return m_parts->triggers; }

tl::expected<std::shared_ptr<const Scene>, QString> Scene::fromJson(const QByteArray& json,
                                                                    catalog::SensorModel model)
{
    const catalog::Value range = catalog::Catalog::hlG2().model(model).measurementRange;
    auto description = readScene(json, double(range * nanometresPerWireUnit));
    if (!description)
        return tl::unexpected(description.error());
    auto parts = std::make_shared<Parts>();
    for (std::size_t i = 0; i < description->workpieces.size(); ++i) {
        parts->workpieces.append(description->workpieces[i].name);
        parts->measuringPoints.push_back(meetingAtMeasuringPoint(*description, i));
    }
    parts->track = trackOf(*description);
    parts->name = std::move(description->name);
    parts->description = std::move(description->description);
    parts->surroundings = std::move(description->surroundings);
    parts->faults = std::move(description->faults);
    parts->triggers = std::move(description->triggers);
    return std::shared_ptr<const Scene>(new Scene(std::move(parts)));
}

tl::expected<std::shared_ptr<const Scene>, QString> Scene::load(const QString& pathOrExample,
                                                                catalog::SensorModel model)
{
    const bool isExample = examples().contains(pathOrExample);
    const QString path =
        isExample ? u"%1/%2%3"_s.arg(exampleFolder, pathOrExample, exampleSuffix) : pathOrExample;
    const QFileInfo info(path);
    if (!info.exists())
        return tl::unexpected(
            u"%1: there is no such file, and no example of that name; the examples are: %2"_s.arg(
                pathOrExample, examples().join(u", "_s)));
    if (!info.isFile()) // opening a pipe would wait for its other end
        return tl::unexpected(u"%1: is not a file"_s.arg(pathOrExample));
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return tl::unexpected(u"%1: %2"_s.arg(pathOrExample, file.errorString()));
    const QByteArray json = file.read(largestSceneFile + 1);
    if (file.error() != QFileDevice::NoError)
        return tl::unexpected(u"%1: %2"_s.arg(pathOrExample, file.errorString()));
    auto scene = fromJson(json, model);
    if (!scene)
        return tl::unexpected(u"%1: %2"_s.arg(pathOrExample, scene.error()));
    return scene;
}

QStringList Scene::examples()
{
    initSceneResources();
    QStringList keys = QDir(exampleFolder).entryList({u'*' + exampleSuffix}, QDir::Files, QDir::Name);
    for (QString& key : keys)
        key.chop(exampleSuffix.size());
    return keys;
}

} // namespace lds::emulator
