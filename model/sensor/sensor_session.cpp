#include "sensor_session.h"

#include "catalog.h"
#include "session_core.h"

namespace lds::sensor {

SensorSession::SensorSession(ports::ConnectionUrl url, ports::LinkFactory& links, ports::Scheduler& scheduler,
                             QObject* parent)
    : QObject(parent)
    , d(std::make_unique<Private>(this, std::move(url), links, scheduler))
{}

SensorSession::~SensorSession()
{
    ++d->depth; // nothing is announced any more but what was promised
    d->close();
    d->announcer.tellLast();
}

const ports::ConnectionUrl& SensorSession::url() const { return d->url; }

QString SensorSession::name() const
{
    if (!d->name.isEmpty())
        return d->name;
    if (d->url.protocol == ports::Protocol::ModbusRtu) {
        const QString port = d->url.host.mid(d->url.host.lastIndexOf(u'/') + 1);
        return QStringLiteral("%1 \u00b7 %2").arg(port).arg(d->url.unit);
    }
    return d->url.port == 502 ? d->url.host : QStringLiteral("%1:%2").arg(d->url.host).arg(d->url.port);
}

void SensorSession::setName(const QString& name)
{
    const Private::Turn turn(*d);
    if (std::exchange(d->name, name.trimmed()) != d->name)
        d->announcer.add(Announcer::News::Identity);
}

catalog::SensorModel SensorSession::model() const { return d->sensorModel(); }

bool SensorSession::modelIsStated() const { return d->url.sensor.has_value(); }

catalog::ModelMask SensorSession::modelsThatFit() const { return d->fit; }

bool SensorSession::modelContradicted() const
{
    return d->url.sensor && !(d->fit & catalog::maskOf(*d->url.sensor));
}

void SensorSession::setModel(catalog::SensorModel model)
{
    const Private::Turn turn(*d);
    if (d->url.sensor == model)
        return;
    d->url.sensor = model;
    d->announcer.add(Announcer::News::Identity);
    if (!d->pending.isEmpty()) // the same edits may break other rules now
        d->announcer.add(Announcer::News::Pending);
}

void SensorSession::setTiming(const Timing& timing) { d->timing = timing; }

void SensorSession::open()
{
    const Private::Turn turn(*d);
    d->open();
}

void SensorSession::close()
{
    const Private::Turn turn(*d);
    d->close();
}

void SensorSession::retryNow()
{
    const Private::Turn turn(*d);
    if (d->retryTimer != 0)
        d->tryAgain();
    else if (d->rereadTimer != 0)
        d->readEverything();
}

void SensorSession::moveTo(const ports::ConnectionUrl& url)
{
    const Private::Turn turn(*d);
    const bool wasOpen = d->connection != Connection::Closed;
    d->close();
    d->url = url;
    d->announcer.add(Announcer::News::Identity);
    if (wasOpen)
        d->open();
}

Connection SensorSession::connection() const { return d->connection; }

const ports::LinkReport& SensorSession::linkReport() const { return d->report; }

bool SensorSession::isSensorNotReady() const { return d->notReady; }

const catalog::Catalog& SensorSession::catalog() const { return catalog::Catalog::hlG2(); }

std::optional<Value> SensorSession::held(ItemId item) const { return d->held.find(item); }

const settings::Values& SensorSession::heldValues() const { return d->held.values(); }

qint64 SensorSession::readAtNs(ItemId item) const { return d->held.readAtNs(item); }

bool SensorSession::reaches(ItemId item) const { return d->reachable.contains(item); }

void SensorSession::readAll()
{
    const Private::Turn turn(*d);
    d->readAgain();
}

const PendingEdits& SensorSession::pending() const { return d->pending; }

tl::expected<settings::ParsedValue, settings::ParseFailure> SensorSession::editText(ItemId item,
                                                                                    const QString& text)
{
    const catalog::SettingItem& description = catalog::hlG2(item);
    const auto parsed = settings::parseValue(description, model(), text);
    if (!parsed)
        return parsed;
    if (!isEditable(item))
        return tl::unexpected(
            settings::ParseFailure{settings::ParseError::NotAChoice, description.limitsFor(model())});
    edit({{item, parsed->effective}});
    return parsed;
}

bool SensorSession::isEditable(ItemId item) const
{
    const catalog::SettingItem& description = catalog::hlG2(item);
    return description.role == catalog::Role::Setting && description.isWritable() &&
           (d->reachable.isEmpty() || d->reachable.contains(item));
}

template <typename Change>
void SensorSession::Private::changePending(Change change)
{
    const Turn turn(*this);
    change(pending);
    announcer.add(Announcer::News::Pending);
}

void SensorSession::edit(const QList<settings::ItemValue>& wanted)
{
    QList<settings::ItemValue> effective;
    for (const settings::ItemValue& each : wanted) {
        if (isEditable(each.item))
            effective.append(
                {each.item, settings::effectiveValue(catalog::hlG2(each.item), model(), each.value)});
    }
    d->changePending([&](PendingEdits& pending) { pending.set(effective, heldValues()); });
}

void SensorSession::revert(const QList<ItemId>& items)
{
    d->changePending([&](PendingEdits& pending) { pending.remove(items); });
}

void SensorSession::revertAll()
{
    d->changePending([](PendingEdits& pending) { pending.clear(); });
}

void SensorSession::undo()
{
    d->changePending([this](PendingEdits& pending) { pending.undo(heldValues()); });
}

void SensorSession::redo()
{
    d->changePending([this](PendingEdits& pending) { pending.redo(heldValues()); });
}

void SensorSession::keepMine(ItemId item)
{
    d->changePending([&](PendingEdits& pending) { pending.confirm(item, heldValues()); });
}

QList<settings::Refusal> SensorSession::problems() const
{
    const auto planned = plan();
    return planned ? QList<settings::Refusal>{} : planned.error().refusals;
}

tl::expected<settings::ApplyPlan, settings::PlanFailure> SensorSession::plan() const
{
    return settings::planWrites(model(), heldValues(), d->pending.wantedValues());
}

bool SensorSession::canWrite() const { return d->canWrite(); }

bool SensorSession::isViewOnly() const { return d->url.viewOnly; }

bool SensorSession::apply()
{
    const Private::Turn turn(*d);
    return d->apply();
}

void SensorSession::cancelApply()
{
    if (d->applying)
        d->applying->cancel();
}

bool SensorSession::isApplying() const { return d->applying != nullptr; }

bool SensorSession::run(ItemId item, Value value)
{
    const Private::Turn turn(*d);
    return d->run(item, value);
}

bool SensorSession::isRunning() const { return d->running != nullptr; }

Saved SensorSession::saved() const { return d->saved; }

LeaseDesk& SensorSession::leases() { return d->desk; }

bool SensorSession::ask(const Lease& lease, const ports::Request& request, QObject* context, Answer answer)
{
    const Private::Turn turn(*d);
    return d->askFor(lease, request, context, std::move(answer));
}

const std::optional<measurement::Measurement>& SensorSession::latest() const { return d->latest; }

const measurement::TrendStore& SensorSession::trend() const { return d->trend; }

void SensorSession::clearTrend()
{
    const Private::Turn turn(*d);
    d->trend.clear();
    d->announcer.add(Announcer::News::Measured);
}

const ports::PollStatistics& SensorSession::pollStatistics() const { return d->statistics; }

double SensorSession::measurementRate() const { return d->rate.perSecond(d->scheduler.nowNs()); }

} // namespace lds::sensor
